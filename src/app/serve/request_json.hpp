// SPDX-License-Identifier: MIT
// Parses the JSON of a request from a page.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace grafverif::app {

/// Returns the value, or a discarded value if `text` is not JSON. Throws no exceptions. Values at the nesting depth
/// `depth` and below are omitted.
inline nlohmann::ordered_json shallow_json(const std::string& text, int depth) {
    using Json = nlohmann::ordered_json;
    return Json::parse(
        text, [depth](int at, Json::parse_event_t, Json&) { return at < depth; }, false);
}

}  // namespace grafverif::app
