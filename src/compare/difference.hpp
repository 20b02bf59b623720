// SPDX-License-Identifier: MIT
// difference: determines the steps, transitions, actions, variables and constraints that were added, removed, changed
// or renamed between two charts.
//
// Steps correspond if they have the same name. Two other steps correspond if they have the same features (type, actions
// and adjacent transitions) and no further step has these features. The comparison of features is repeated until no
// further steps correspond. Then the comparison is repeated without the adjacent transitions as a feature. Transitions
// correspond if they connect the same steps with the same condition. Other transitions correspond if they have the same
// name. All remaining transitions correspond if they connect the same steps. Names of transitions, the order of
// elements and the layout of the text are ignored.
#pragma once

#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/comparison.hpp"

namespace grafverif {

/// Returns the differences in the order variables, constraints, steps with their actions, transitions. The result is
/// empty if and only if the charts differ at most in order, names of transitions, and data that is not part of the
/// text.
std::vector<ChartChange> difference(const Chart& a, const Chart& b);

}  // namespace grafverif
