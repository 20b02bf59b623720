// SPDX-License-Identifier: MIT
// Writes source positions as members of JSON objects.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "report/report_source.hpp"

namespace grafverif {

/// Adds the members `file`, `line` and `column`, which are `null` without a position.
inline void add_place(nlohmann::ordered_json& object, const std::optional<FilePlace>& where) {
    object["file"] = where ? nlohmann::ordered_json(where->file) : nullptr;
    object["line"] = where ? nlohmann::ordered_json(where->at.line) : nullptr;
    object["column"] = where ? nlohmann::ordered_json(where->at.column) : nullptr;
}

}  // namespace grafverif
