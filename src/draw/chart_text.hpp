// SPDX-License-Identifier: MIT
// ChartText: texts of the source file that the Chart does not contain, in the order of its tables. Empty texts and
// lists are ignored.
#pragma once

#include <string>
#include <vector>

namespace grafverif {

struct ChartText {
    std::vector<std::string> comments = {};                      ///< comments of steps; they are drawn
    std::vector<std::string> transitions = {}, continuous = {};  ///< conditions as written; drawn in Notation::Text
    std::vector<std::string> events = {}, values = {};           ///< of stored actions, as written
};

}  // namespace grafverif
