// SPDX-License-Identifier: MIT
// MCP server: implements the Model Context Protocol (versions 2024-11-05, 2025-03-26 and 2025-06-18) over a byte
// stream, with one message per line. The server ends when the client closes the stream.
//
// One thread receives messages. A second thread handles the messages in the order of arrival and never waits for a
// tool. Each call of a tool is executed by a worker thread, which runs commands of grafverif in a separate process.
// Therefore the limits of time and memory apply to each call separately, and neither invalid input nor a call that
// reaches its limits can end the server. Invalid messages do not end the server either: the server sends an error
// response.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "rpc/framing.hpp"
#include "support/program.hpp"

namespace grafverif::mcp {

/// An execution of a grafverif command.
struct CommandRun {
    std::vector<std::string> arguments = {};  ///< the command and its arguments
    std::string input = {};                   ///< standard input of the command
    std::chrono::steady_clock::time_point deadline = {};
    const std::atomic<bool>* stop = nullptr;  ///< cancellation flag
};

/// Default values of the arguments `timeout` (seconds) and `max_memory` (MiB). If a maximum value of the server is
/// smaller than the default value, the maximum value applies.
inline constexpr std::int64_t usual_timeout_s = 60, usual_memory_mib = 2048;

/// Callbacks and settings of the program that runs the server.
struct ServerEnvironment {
    std::string version = {};
    /// Absolute paths of the folders below which tools may read files; at least one path.
    std::vector<std::string> folders = {};
    std::int64_t longest_call_s = 600;                  ///< maximum value of the argument `timeout`, in seconds
    std::int64_t largest_call_mib = 8192;               ///< maximum value of the argument `max_memory`, in MiB
    std::chrono::milliseconds progress_interval{1000};  ///< interval between progress notifications of a call

    /// Executes a command. Several threads call the function simultaneously. The function may throw std::system_error.
    std::function<ProgramResult(const CommandRun& run)> execute = {};
    /// Reserves memory for the report of the next failed allocation. If the function is empty, no memory is reserved.
    std::function<void()> keep_memory_back = {};
    /// Ends a call of `Receive` that waits for bytes. The server calls the function if the client no longer reads.
    std::function<void()> hang_up = {};

    /// `default_timeout_s` and `default_memory_mib` return the limits of a call without the arguments `timeout` and
    /// `max_memory`.
    std::int64_t default_timeout_s() const { return std::min(usual_timeout_s, longest_call_s); }
    std::int64_t default_memory_mib() const { return std::min(usual_memory_mib, largest_call_mib); }
};

/// Sends bytes to the client; returns after all bytes have been written. Returns false if the client has disappeared.
using Send = std::function<bool(std::string_view bytes)>;

/// Limits of the server: size of a message in bytes, number of messages that wait to be handled, number of calls that
/// run simultaneously, and number of calls that wait.
inline constexpr std::size_t largest_message = std::size_t{4} << 20U, most_messages = 64, most_running = 4,
                             most_waiting = 60;

/// Serves a client until the client closes the stream or disappears, and then cancels running calls.
void converse(const rpc::Receive& receive, const Send& send, const ServerEnvironment& environment);

}  // namespace grafverif::mcp
