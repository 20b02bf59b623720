// SPDX-License-Identifier: MIT
// CancellableInput: standard input of a server, which a client may keep open without writing.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <span>

namespace grafverif::app {

/// Reads standard input until `end_requested` is true. A call of `stop` ends the wait for input.
class CancellableInput {
public:
    /// Throws std::system_error if the system refuses a pipe.
    explicit CancellableInput(const std::atomic<bool>& end_requested);
    ~CancellableInput();
    CancellableInput(const CancellableInput&) = delete;
    CancellableInput& operator=(const CancellableInput&) = delete;

    /// Waits for bytes and stores some of them. Returns their number; 0 at the end.
    std::size_t receive(std::span<char> buffer) const;
    void stop() const;

private:
    const std::atomic<bool>& end_requested_;
    std::array<int, 2> ends_ = {};
};

}  // namespace grafverif::app
