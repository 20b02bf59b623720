// SPDX-License-Identifier: MIT
// Cones of influence: sets of variables whose equations depend only on variables of the set and on inputs. The
// behaviour of a cone does not depend on the rest of the chart, provided that the rest does not abort a run or make an
// instant infinite. Therefore every run of the chart, restricted to the cone, is a run of the cone, and an event that
// is impossible in a cone is impossible in the chart. To confirm that a run of a cone is a run of the chart, the chart
// is executed with the same inputs.
#pragma once

#include <vector>

#include "grafverif/ir/equations.hpp"

namespace grafverif::analysis {

/// A cone: for each variable of the equations, true if the cone contains the variable.
using Cone = std::vector<bool>;

/// The variables that determine the next value of each variable, through firing conditions, timers and stored actions.
/// For a firing condition, these are the variables that the condition reads; for an output, the variables that its
/// value reads. An input has no dependencies.
class Dependencies {
public:
    explicit Dependencies(const Equations& equations);

    const std::vector<std::uint32_t>& of(std::uint32_t variable) const { return reads_[variable]; }
    /// Returns, for each variable, the number of its strongly connected component.
    std::vector<std::uint32_t> components() const;

private:
    std::vector<std::vector<std::uint32_t>> reads_ = {};
};

/// Returns the cones of all steps, transitions, stored variables, outputs and conflicts of forcing orders in order of
/// increasing size, followed by the complete chart. If there are too many cones, or if the cones overlap so much that
/// they do not save work, the result contains only the complete chart.
std::vector<Cone> cones(const Equations& equations);

}  // namespace grafverif::analysis
