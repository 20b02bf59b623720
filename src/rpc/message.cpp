// SPDX-License-Identifier: MIT
#include "rpc/message.hpp"

#include <nlohmann/json.hpp>

namespace grafverif::rpc {

bool is_id(const Json& id) { return id.is_string() || id.is_number_integer(); }

const Json& member(const Json& object, const char* name) {
    static const Json nothing;
    if (!object.is_object()) return nothing;
    const auto found = object.find(name);
    return found != object.end() ? *found : nothing;
}

std::string method_of(const Json& message) {
    const Json& method = member(message, "method");
    return method.is_string() ? method.get<std::string>() : std::string();
}

bool nests_too_deep(std::string_view json) {
    constexpr std::size_t deepest = 200;
    std::size_t depth = 0;
    bool quoted = false;
    for (std::size_t at = 0; at < json.size(); ++at) {
        const char byte = json[at];
        if (quoted) {
            if (byte == '\\') ++at;
            quoted = byte != '"';
        } else if (byte == '"') {
            quoted = true;
        } else if (byte == '[' || byte == '{') {
            if (++depth > deepest) return true;
        } else if ((byte == ']' || byte == '}') && depth > 0) {
            --depth;
        }
    }
    return false;
}

Item item_of(Framed framed) {
    if (!framed.error_text.empty()) return {.error_text = std::move(framed.error_text)};
    if (nests_too_deep(framed.body)) return {.error_text = "the message is nested too deeply"};
    Json message = Json::parse(framed.body, nullptr, false);
    if (message.is_discarded()) return {.error_text = "the message is not valid JSON"};
    return {.message = std::make_shared<const Json>(std::move(message))};
}

Json response(const Json& id, Json result) { return {{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}}; }

Json failure(const Json& id, int code, const std::string& message) {
    return {{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", message}}}};
}

std::string text_of(const Json& message) { return message.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace grafverif::rpc
