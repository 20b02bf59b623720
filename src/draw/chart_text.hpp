// SPDX-License-Identifier: MIT
// ChartText: texts of the source file that a Chart does not contain, in the order of the tables of the Chart. For an
// empty text or list, the drawing uses only the Chart.
#pragma once

#include <string>
#include <vector>

namespace grafverif {

struct ChartText {
    /// Comments of steps, which are included in the drawing.
    std::vector<std::string> comments = {};
    /// Conditions in the notation of the source, for drawings with Notation::Text.
    std::vector<std::string> transitions = {}, continuous = {};
    std::vector<std::string> events = {}, values = {};  ///< events and values of stored actions as in the source
};

}  // namespace grafverif
