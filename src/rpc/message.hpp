// SPDX-License-Identifier: MIT
// Parses and prints messages of JSON-RPC 2.0, on which LSP and MCP are based.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "rpc/framing.hpp"
#include "rpc/inbox.hpp"

namespace grafverif::rpc {

using Json = nlohmann::json;

// Error codes of JSON-RPC 2.0, section 5.1.
inline constexpr int parse_error = -32700, invalid_request = -32600, no_such_method = -32601, invalid_params = -32602,
                     internal_error = -32603;

/// An error response to a request. A handler of a request throws a RequestError.
struct RequestError {
    int code = 0;
    std::string message = {};
};

/// True for the id of a request: a string or an integer.
bool is_id(const Json& id);
/// Returns the member of an object; null if `object` is not an object or has no such member.
const Json& member(const Json& object, const char* name);
/// Returns the method of a request or notification, otherwise an empty string.
std::string method_of(const Json& message);

/// True if the brackets of a text are nested deeper than in any valid message. A text that is nested more deeply is not
/// parsed.
bool nests_too_deep(std::string_view json);
/// Parses a frame. If the JSON is invalid or nested too deeply, the result is an item with an error.
Item item_of(Framed framed);

Json response(const Json& id, Json result);
Json failure(const Json& id, int code, const std::string& message);
/// Returns the message as one line of valid UTF-8.
std::string text_of(const Json& message);

}  // namespace grafverif::rpc
