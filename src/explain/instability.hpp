// SPDX-License-Identifier: MIT
// Explanations for loops that are not yet quiescent, or never become so.
#pragma once

#include <string>

#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// True if `run`, which violates `property`, ends at power-on: no state of it is quiescent, and no time passes in it.
/// Only for a property about single states that is checked in all of them; false for any other.
bool is_violated_at_power_on(const Network& network, const Property& property, const Run& run);

/// The explanation for such a property; `at_stable` is the verdict on the same property, checked in quiescent states
/// only.
std::string power_on_text(const Verdict& at_stable);

/// Explanation of a run that repeats forever within one instant while only controllers move: the unstable controllers
/// and their cycles of situations. Empty for any other run.
std::string unstable_text(const ChartRun& run);

}  // namespace grafverif
