// SPDX-License-Identifier: MIT
// difference: Chart, Chart -> textual differences of the second chart: steps, transitions, actions, variables,
// constraints that were added, removed, changed or renamed.
//
// Steps correspond if they have the same name. Others correspond if they are the only ones with equal features: kind,
// actions, and the adjacent transitions to corresponding steps (repeated while this finds more). Transitions correspond
// if they connect the same steps with the same condition; otherwise if they have the same name, or are the only ones
// between their steps. Names of transitions, order and layout are ignored.
#pragma once

#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/comparison.hpp"

namespace grafverif {

/// In the order variables, constraints, steps with their actions, transitions. Empty iff both charts are equal up to
/// order, names of transitions, and data that is not part of the text.
std::vector<ChartChange> difference(const Chart& a, const Chart& b);

}  // namespace grafverif
