// SPDX-License-Identifier: MIT
// Prints JSON as text that is valid for all string contents and safe to print on a terminal. Characters that control a
// terminal (see printable) are written as `\u` escapes, which every JSON parser reads back. Invalid UTF-8 becomes
// U+FFFD.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace grafverif {

/// Returns the value as text. `indent` is the number of spaces per level; with -1, the result is a single line.
std::string json_text(const nlohmann::ordered_json& value, int indent = 2);

/// Returns the count, or `null` if the count is unknown.
inline nlohmann::ordered_json optional_json(std::optional<std::uint64_t> count) {
    return count ? nlohmann::ordered_json(*count) : nlohmann::ordered_json(nullptr);
}

/// Returns the text, or `null` if the text is empty.
inline nlohmann::ordered_json text_or_null(const std::string& text) {
    return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
}

}  // namespace grafverif
