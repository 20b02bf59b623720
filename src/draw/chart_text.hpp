// SPDX-License-Identifier: MIT
// ChartText: what a file says of a chart and the Chart does not keep, in the order of its tables. Empty texts, and lists,
// say nothing.
#pragma once

#include <string>
#include <vector>

namespace grafverif {

struct ChartText {
    std::vector<std::string> comments = {};                      ///< of steps; they are drawn
    std::vector<std::string> transitions = {}, continuous = {};  ///< conditions as written; drawn in Notation::Text
    std::vector<std::string> events = {}, values = {};           ///< of stored actions, likewise
};

}  // namespace grafverif
