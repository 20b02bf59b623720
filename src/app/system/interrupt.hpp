// SPDX-License-Identifier: MIT
// Interrupt: while one exists, Ctrl-C (SIGINT), SIGTERM and SIGHUP ask for an end instead of ending the program; a
// second one ends it, and the programs that it runs. Signals that were ignored before stay ignored (`nohup`).
#pragma once

#include <atomic>

namespace grafverif::app {

class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    const std::atomic<bool>& asked() const;
};

/// While one exists, none of these signals ends the program: one that would does so afterwards. For what must not be
/// left half done; it lasts no longer than that.
class Uninterrupted {
public:
    Uninterrupted();
    ~Uninterrupted();
    Uninterrupted(const Uninterrupted&) = delete;
    Uninterrupted& operator=(const Uninterrupted&) = delete;

    /// For who ends the process by other means than a signal: true if none exists, and then none begins any more. Waits
    /// for nothing.
    static bool none_from_now_on();
};

}  // namespace grafverif::app
