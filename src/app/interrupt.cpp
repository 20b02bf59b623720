// SPDX-License-Identifier: MIT
#include "app/interrupt.hpp"

#include <csignal>

namespace grafverif::app {

namespace {

// A signal handler reaches nothing else.
std::atomic<bool> interrupted = false;
std::atomic<int> listeners = 0;   ///< Interrupts; the first of them listens
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void note_interrupt(int) {
    interrupted = true;
    std::signal(SIGINT, SIG_DFL);
}

}  // namespace

Interrupt::Interrupt() {
    if (listeners++ != 0) return;
    interrupted = false;
    before_ = std::signal(SIGINT, note_interrupt);
}

Interrupt::~Interrupt() {
    if (--listeners == 0) std::signal(SIGINT, before_ == SIG_ERR ? SIG_DFL : before_);
}

const std::atomic<bool>& Interrupt::asked() const { return interrupted; }

}  // namespace grafverif::app
