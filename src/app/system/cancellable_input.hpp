// SPDX-License-Identifier: MIT
// CancellableInput: standard input of a server, which a client may keep open without writing.
#pragma once

#include <atomic>
#include <cstddef>
#include <iosfwd>
#include <span>

#include "check/shares.hpp"
#include "pipeline/descriptor.hpp"
#include "rpc/framing.hpp"

namespace grafverif::app {

/// Reads standard input until `end_requested` is true or the deadline has passed. A call of `stop` ends the wait for
/// input.
class CancellableInput {
public:
    /// Throws std::system_error if the system refuses a pipe.
    explicit CancellableInput(const std::atomic<bool>& end_requested, Deadline deadline = {})
        : end_requested_(end_requested), deadline_(deadline) {}

    /// Waits for bytes and stores some of them. Returns the number of stored bytes; 0 at the end of the input.
    std::size_t receive(std::span<char> buffer) const;
    void stop() const;

private:
    const std::atomic<bool>& end_requested_;
    Deadline deadline_;
    Pipe pipe_ = make_pipe();
};

/// Returns a function that reads the stream. The stream must outlive the function.
rpc::Receive receive_from(std::istream& in);

}  // namespace grafverif::app
