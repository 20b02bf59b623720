// SPDX-License-Identifier: MIT
// JSON as text that is valid for all string contents and safe to print on a terminal. Characters that control a
// terminal (see printable) are written as `\u` escapes, which every JSON parser reads back. Invalid UTF-8 becomes
// U+FFFD.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace grafverif {

/// Returns the value as text. `indent` is the number of spaces per level; -1 prints everything in one line.
std::string json_text(const nlohmann::ordered_json& value, int indent = 2);

/// Returns the count; `null` if it is unknown.
inline nlohmann::ordered_json optional_json(std::optional<std::uint64_t> count) {
    return count ? nlohmann::ordered_json(*count) : nlohmann::ordered_json(nullptr);
}

/// Returns the text; `null` if it is empty.
inline nlohmann::ordered_json text_or_null(const std::string& text) {
    return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
}

}  // namespace grafverif
