// SPDX-License-Identifier: MIT
// StepName: what a step is called, in parts, so that nobody takes a name to pieces.
#pragma once

#include <string>

namespace grafverif {

struct StepName {
    std::string partial = {};  ///< the partial chart; empty: one without a name
    std::string step = {};     ///< `2`

    /// `2`, `G2.2`
    std::string text() const { return (partial.empty() ? "" : partial + ".") + step; }
    /// The step variable, as conditions write it: `X2`, `G2.X2`.
    std::string variable() const { return (partial.empty() ? "" : partial + ".") + "X" + step; }

    bool operator==(const StepName&) const = default;
};

}  // namespace grafverif
