// SPDX-License-Identifier: MIT
// StepName: the name of a step, divided into the name of its partial chart and the name of the step
// within this partial chart.
#pragma once

#include <string>

namespace grafverif {

struct StepName {
    std::string partial = {};  ///< name of the partial chart; empty if it has no name
    std::string step = {};     ///< name of the step in its partial chart, such as `2`

    /// Returns the qualified name of the step: `2`, or `G2.2` for a step of the partial chart G2.
    std::string text() const { return (partial.empty() ? "" : partial + ".") + step; }
    /// Returns the step variable in the notation of conditions: `X2`, or `G2.X2` for a step of the partial chart G2.
    std::string variable() const { return (partial.empty() ? "" : partial + ".") + "X" + step; }

    bool operator==(const StepName&) const = default;
};

}  // namespace grafverif
