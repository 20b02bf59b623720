// SPDX-License-Identifier: MIT
// Interrupt: while an object exists, Ctrl-C (SIGINT), SIGTERM and SIGHUP request an end instead of ending the program.
// A second signal ends the program and its children. Signals that were ignored before remain ignored (`nohup`).
#pragma once

#include <atomic>

namespace grafverif::app {

class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    const std::atomic<bool>& requested() const;
};

/// While an object exists, SIGINT, SIGTERM and SIGHUP do not end the program; a signal that arrives during this time
/// ends the program afterwards. Use SignalBlocker for short sections of code that must be
/// completed.
class SignalBlocker {
public:
    SignalBlocker();
    ~SignalBlocker();
    SignalBlocker(const SignalBlocker&) = delete;
    SignalBlocker& operator=(const SignalBlocker&) = delete;

    /// Returns true if no SignalBlocker exists. After the function has returned true, no SignalBlocker can be created.
    /// Call this function before the process is ended other than by a signal. Does not wait.
    static bool none_from_now_on();
};

}  // namespace grafverif::app
