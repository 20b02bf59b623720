// SPDX-License-Identifier: MIT
// difference: Chart, Chart -> what the text of the second says otherwise: steps, transitions, actions, variables,
// constraints that were added, removed, changed, renamed.
//
// Steps are the same that have one name; of the others those that alone look alike: kind, actions, and the transitions beside
// them, between steps that are known to be the same (looked at again as long as that finds more). Transitions are the same
// that lie between the same steps with the same condition, else those with one name, else those alone between their steps. Names of
// transitions, order and layout say nothing.
#pragma once

#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/comparison.hpp"

namespace grafverif {

/// In the order variables, constraints, steps with their actions, transitions. Empty iff both are the same chart but for
/// order, names of transitions, and what no text says.
std::vector<ChartChange> difference(const Chart& a, const Chart& b);

}  // namespace grafverif
