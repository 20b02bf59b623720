// SPDX-License-Identifier: MIT
// Explains violations in states in which the closed loop is not yet quiescent, and runs in which it never becomes
// quiescent.
#pragma once

#include <string>

#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// True if `run`, which violates `property`, ends at power-on: none of the states of the run is quiescent, and no time
/// passes in the run. Returns false if the property is not a property of all states, or has `at stable`.
bool is_violated_at_power_on(const Network& network, const Property& property, const Run& run);

/// Returns the explanation of a violation at power-on. `at_stable` is the verdict on the same property with `at
/// stable`, that is, checked only in quiescent states.
std::string power_on_text(const Verdict& at_stable);

/// Returns the explanation of a run that repeats forever within one instant and in which only controllers move. The
/// explanation consists of the unstable controllers and their cycles of situations. For any other run, the result is
/// empty.
std::string unstable_text(const ChartRun& run);

}  // namespace grafverif
