// SPDX-License-Identifier: MIT
// Interrupt: while one exists, Ctrl-C asks for an end instead of ending the program. A second Ctrl-C ends it.
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

private:
    void (*before_)(int) = nullptr;
};

}  // namespace grafverif::app
