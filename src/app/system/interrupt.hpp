// SPDX-License-Identifier: MIT
// Interrupt: while one exists, Ctrl-C (SIGINT), SIGTERM and SIGHUP request an end instead of ending the program. A
// second one ends the program and its children. Signals that were ignored before stay ignored (`nohup`).
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

/// While one exists, none of these signals ends the program; a pending one does so afterwards. For short sections that
/// must not be left half done.
class SignalBlocker {
public:
    SignalBlocker();
    ~SignalBlocker();
    SignalBlocker(const SignalBlocker&) = delete;
    SignalBlocker& operator=(const SignalBlocker&) = delete;

    /// For code that ends the process other than by a signal: true if none exists, and then no new one can be created.
    /// Does not wait.
    static bool none_from_now_on();
};

}  // namespace grafverif::app
