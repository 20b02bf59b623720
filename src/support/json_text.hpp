// SPDX-License-Identifier: MIT
// JSON as text: valid whatever its strings hold, and clean on a terminal: what a terminal obeys (see printable) is
// written as `\u` and its number, which every reader of JSON takes for the character; what is no UTF-8 becomes U+FFFD.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace grafverif {

/// `indent`: blanks per level; -1: in one line.
std::string json_text(const nlohmann::ordered_json& value, int indent = 2);

}  // namespace grafverif
