// SPDX-License-Identifier: MIT
#include "app/interrupt.hpp"

#include <csignal>

namespace grafverif::app {

namespace {

// A signal handler reaches nothing else.
std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void note_interrupt(int) {
    interrupted = true;
    std::signal(SIGINT, SIG_DFL);
}

}  // namespace

Interrupt::Interrupt() {
    interrupted = false;
    before_ = std::signal(SIGINT, note_interrupt);
}

Interrupt::~Interrupt() { std::signal(SIGINT, before_ == SIG_ERR ? SIG_DFL : before_); }

const std::atomic<bool>& Interrupt::asked() const { return interrupted; }

}  // namespace grafverif::app
