// SPDX-License-Identifier: MIT
// JSON as text: valid whatever its strings hold, and clean on a terminal: what a terminal obeys (see printable) is
// written as `\u` and its number, which every reader of JSON takes for the character; what is no UTF-8 becomes U+FFFD.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace grafverif {

/// `indent`: blanks per level; -1: in one line.
std::string json_text(const nlohmann::ordered_json& value, int indent = 2);

/// `null` for a count that is not known.
inline nlohmann::ordered_json optional_json(std::optional<std::uint64_t> count) {
    return count ? nlohmann::ordered_json(*count) : nlohmann::ordered_json(nullptr);
}

/// `null` for a text that there is not.
inline nlohmann::ordered_json text_or_null(const std::string& text) {
    return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
}

}  // namespace grafverif
