// SPDX-License-Identifier: MIT
// Cones: parts of equations that depend on nothing outside of them but inputs. What a cone does, it does whatever the
// rest of the chart does, as long as the rest does not break a run off or keep an instant from ending: every run of the
// chart, looked at in the cone alone, is a run of the cone. So what never happens in a cone never happens in the chart;
// a run of the cone is one of the chart if the chart, made to run with the same inputs, confirms it.
#pragma once

#include <vector>

#include "grafverif/ir/equations.hpp"

namespace grafverif::analysis {

/// Which variables of the equations are in it.
using Cone = std::vector<bool>;

/// What each variable reads to become what it is: through firing conditions, timers and stored actions. Of a firing
/// condition what it reads, of an output what its value reads; of an input nothing.
class Dependencies {
public:
    explicit Dependencies(const Equations& equations);

    const std::vector<std::uint32_t>& of(std::uint32_t variable) const { return reads_[variable]; }
    /// Per variable the number of its component: variables that depend on each other have the same.
    std::vector<std::uint32_t> components() const;

private:
    std::vector<std::vector<std::uint32_t>> reads_ = {};
};

/// The cones of all steps, transitions, stored variables, outputs and conflicts of orders, the smallest first, and the
/// whole last. Only the whole where they are so many, or overlap so much, that they save nothing.
std::vector<Cone> cones(const Equations& equations);

}  // namespace grafverif::analysis
