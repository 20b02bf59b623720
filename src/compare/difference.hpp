// SPDX-License-Identifier: MIT
// difference: determines the textual differences between two charts: steps, transitions, actions, variables and
// constraints that were added, removed, changed or renamed.
//
// Steps correspond if they have the same name. Other steps correspond if they are the only ones with equal features:
// type, actions, and adjacent transitions to corresponding steps. This is repeated until no further steps are found.
// Transitions correspond if they connect the same steps with the same condition. Other transitions correspond if they
// have the same name, or are the only ones between their steps. Names of transitions, order and layout are ignored.
#pragma once

#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/comparison.hpp"

namespace grafverif {

/// Returns the differences in the order variables, constraints, steps with their actions, transitions. The result is
/// empty exactly if both charts are equal, apart from order, names of transitions, and data that is not part of the
/// text.
std::vector<ChartChange> difference(const Chart& a, const Chart& b);

}  // namespace grafverif
