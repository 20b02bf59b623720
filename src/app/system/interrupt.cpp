// SPDX-License-Identifier: MIT
#include "app/system/interrupt.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <mutex>

#include "app/system/child.hpp"

namespace grafverif::app {

namespace {

constexpr std::array signals = {SIGINT, SIGTERM, SIGHUP};

// A signal handler accesses only the following objects.
std::atomic<bool> interrupted = false;
std::atomic<int> listeners = 0;       ///< number of Interrupt objects
std::atomic<int> guards = 0;          ///< number of SignalBlocker objects
std::atomic<int> pending_signal = 0;  ///< signal to raise after the last SignalBlocker has ended; 0: no signal
std::array<struct sigaction, signals.size()> before = {};  ///< written only while note_signal is not installed
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

/// Mutex that serializes the constructors and destructors of Interrupt and SignalBlocker. Signal
/// handlers do not lock this mutex.
std::mutex& door() {
    static std::mutex mutex;
    return mutex;
}

/// Kills all children, restores the original disposition of the signal, and raises the signal.
void execute(int signal) {
    kill_children_at_once();
    for (std::size_t k = 0; k < signals.size(); ++k)
        if (signals[k] == signal) ::sigaction(signal, &before[k], nullptr);
    std::raise(signal);
}

extern "C" void note_signal(int signal) {
    const int error = errno;
    if (listeners == 0 || interrupted.exchange(true)) {
        if (guards != 0) pending_signal = signal;
        else execute(signal);
    }
    errno = error;
}

void watch() {
    if (listeners + guards != 0) return;
    struct sigaction action = {};
    action.sa_handler = note_signal;
    action.sa_flags = SA_RESTART;
    ::sigemptyset(&action.sa_mask);
    for (std::size_t k = 0; k < signals.size(); ++k) {
        ::sigaction(signals[k], nullptr, &before[k]);
        if (before[k].sa_handler != SIG_IGN) ::sigaction(signals[k], &action, nullptr);
    }
}

void unwatch() {
    if (listeners + guards != 0) return;
    for (std::size_t k = 0; k < signals.size(); ++k) ::sigaction(signals[k], &before[k], nullptr);
}

}  // namespace

Interrupt::Interrupt() {
    const std::lock_guard hold(door());
    watch();
    if (listeners == 0) interrupted = false;
    ++listeners;
}

Interrupt::~Interrupt() {
    const std::lock_guard hold(door());
    --listeners;
    unwatch();
}

const std::atomic<bool>& Interrupt::requested() const { return interrupted; }

SignalBlocker::SignalBlocker() {
    const std::lock_guard hold(door());
    watch();
    ++guards;
}

bool SignalBlocker::none_from_now_on() {
    if (!door().try_lock()) return false;
    if (guards == 0) return true;  // the lock remains held, so that no SignalBlocker can be created
    door().unlock();
    return false;
}

SignalBlocker::~SignalBlocker() {
    const std::lock_guard hold(door());
    --guards;
    unwatch();
    if (guards == 0)
        if (const int signal = pending_signal.exchange(0); signal != 0) execute(signal);
}

}  // namespace grafverif::app
