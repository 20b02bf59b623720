// SPDX-License-Identifier: MIT
// Analyses the structure of a chart, without a search of its situations.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif::analysis {

/// For each variable of the equations: true if an equation reads it.
std::vector<bool> variables_read(const Equations& equations);

/// Returns cycles of forcing orders. Each order forces the partial chart that contains the step of the next order, and
/// the last order forces the partial chart that contains the step of the first order.
std::vector<std::vector<Id<Chart::ForcingOrder>>> forcing_cycles(const Chart& chart);

/// Returns the forcing orders on partial charts whose activity an enclosing step also controls, together with this
/// step. The step encloses the forced partial chart itself, or a chart that contains it.
std::vector<std::pair<Id<Chart::ForcingOrder>, Id<Chart::Step>>> orders_on_enclosed(const Chart& chart);

/// Returns the partial chart that a forcing order of the conflict forces, or an empty string if the order is not found.
std::string conflict_subject(const Chart& chart, const Equations& equations, const Equations::Conflict& conflict);

/// Returns pairs of transitions with a common upstream step, in order.
std::vector<std::pair<Id<Chart::Transition>, Id<Chart::Transition>>> branches(const Chart& chart);

}  // namespace grafverif::analysis
