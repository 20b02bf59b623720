// SPDX-License-Identifier: MIT
// The language server: implements LSP 3.17 over a byte stream. The server ends when the client sends `exit` or
// disappears.
//
// One thread only receives messages, so that a request can be cancelled, and a change can stop a check, while a
// response is computed. A second thread handles the messages in the order of arrival, and a third thread runs the
// checks. Invalid input does not end the server. If the protocol defines an error response for the input, the server
// sends it.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rpc/framing.hpp"

namespace grafverif::lsp {

using rpc::Receive;
/// Sends bytes to the client; returns after all bytes have been written.
using Send = std::function<void(std::string_view bytes)>;

/// Callbacks and settings of the program that runs the server.
struct ServerEnvironment {
    std::string version = {};
    std::vector<std::string> include_folders = {};
    std::vector<std::string> within = {};  ///< folders to which reading is restricted; unrestricted if empty

    /// Returns true if the client's process exists; called periodically.
    std::function<bool(std::int64_t process)> is_alive = {};
    /// Time limit for the check of a loop or the analysis of a chart; unlimited if empty.
    std::optional<std::chrono::milliseconds> response_timeout = {};
    /// Returns the address of a page that draws and simulates the file. The function creates the page if necessary, and
    /// may throw std::system_error. The function is empty if pages are not available.
    std::function<std::string(const std::string& path)> simulator = {};
    /// Stores a text temporarily under this name for another program, and returns its path. The function is empty if
    /// texts cannot be stored temporarily.
    std::function<std::string(const std::string& name, const std::string& text)> keep = {};
    /// Reserves memory for the report of the next failed allocation. The server calls the function between messages. If
    /// the function is empty, no memory is reserved.
    std::function<void()> keep_memory_back = {};
    /// Ends a call of `Receive` that waits for bytes. The server calls the function if the client has disappeared
    /// without closing the stream.
    std::function<void()> hang_up = {};
};

/// Requested: `exit` after `shutdown`; Unrequested: `exit` without `shutdown`; Gone: the client disappeared.
enum class Ending { Requested, Unrequested, Gone };

Ending converse(const Receive& receive, const Send& send, const ServerEnvironment& surroundings);

}  // namespace grafverif::lsp
