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

/// While an object exists, none of these signals ends the program; a pending signal does so afterwards. It is for short
/// sections that must be completed.
class SignalBlocker {
public:
    SignalBlocker();
    ~SignalBlocker();
    SignalBlocker(const SignalBlocker&) = delete;
    SignalBlocker& operator=(const SignalBlocker&) = delete;

    /// For code that ends the process other than by a signal: returns true if no object exists; after that, none can be
    /// created. Does not wait.
    static bool none_from_now_on();
};

}  // namespace grafverif::app
