// SPDX-License-Identifier: MIT
// The language server: LSP 3.17 over a stream of bytes, until the client says `exit`, or is gone.
//
// One thread receives, so that a request can be cancelled and a change can end a proof while something is being made; one
// answers, in the order of arrival; one proves. Whatever arrives, the server lives on: what is no message is answered
// with an error, as far as the protocol has an answer for it.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lsp/framing.hpp"

namespace grafverif::lsp {

/// What the server is told and given by who starts it.
struct Surroundings {
    std::string version = {};
    std::vector<std::string> include_folders = {};
    /// Whether the process of the client is there; asked now and then.
    std::function<bool(std::int64_t process)> is_alive = {};
    /// How long a check of a loop, or a look into a chart, may take; empty: as long as it takes.
    std::optional<std::chrono::milliseconds> patience = {};
    /// The address of a page on which the file is simulated and drawn, made if there is none; may throw
    /// std::system_error. Empty: there are no pages.
    std::function<std::string(const std::string& path)> simulator = {};
    /// Keeps a text for a while, under this name, for another program: its path. Empty: nothing is kept.
    std::function<std::string(const std::string& name, const std::string& text)> keep = {};
    /// Ends the waiting of `Receive`, where the client is gone without closing its end.
    std::function<void()> hang_up = {};
};

/// `exit` came after `shutdown`; without it; or the client was gone.
enum class Ending { Asked, Unasked, Gone };

Ending converse(const Receive& receive, const Send& send, const Surroundings& surroundings);

}  // namespace grafverif::lsp
