// SPDX-License-Identifier: MIT
// Cones of influence: parts of equations that depend on nothing outside them but inputs. The behaviour of a cone does
// not depend on the rest of the chart, provided that the rest does not abort a run or make an instant infinite. So
// every run of the chart, restricted to the cone, is a run of the cone, and what never happens in a cone never happens
// in the chart. A run of the cone is one of the chart if the chart, executed with the same inputs, confirms it.
#pragma once

#include <vector>

#include "grafverif/ir/equations.hpp"

namespace grafverif::analysis {

/// Marks the variables of the equations that it contains.
using Cone = std::vector<bool>;

/// The variables that determine the next value of each variable: through firing conditions, timers and stored actions.
/// For a firing condition the variables that it reads, for an output those that its value reads, for an input none.
class Dependencies {
public:
    explicit Dependencies(const Equations& equations);

    const std::vector<std::uint32_t>& of(std::uint32_t variable) const { return reads_[variable]; }
    /// Per variable the number of its strongly connected component.
    std::vector<std::uint32_t> components() const;

private:
    std::vector<std::vector<std::uint32_t>> reads_ = {};
};

/// The cones of all steps, transitions, stored variables, outputs and conflicts of orders, the smallest first, and the
/// complete chart last. Only the complete chart if the cones are so many, or overlap so much, that they save nothing.
std::vector<Cone> cones(const Equations& equations);

}  // namespace grafverif::analysis
