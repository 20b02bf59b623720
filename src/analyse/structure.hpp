// SPDX-License-Identifier: MIT
// Structural analysis of a chart, without a search.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif::analysis {

/// Per variable of the chart: true if an equation reads it.
std::vector<bool> variables_read(const Equations& equations);

/// Cycles of forcing orders: each order forces the partial chart that contains the step of the next one, cyclically.
std::vector<std::vector<Id<Chart::ForcingOrder>>> forcing_cycles(const Chart& chart);

/// Orders on partial charts that are also governed by an enclosing step, with that step: of the partial chart itself or
/// of one around it.
std::vector<std::pair<Id<Chart::ForcingOrder>, Id<Chart::Step>>> orders_on_enclosed(const Chart& chart);

/// The partial chart that an order of the conflict forces; empty if the order is not found.
std::string conflict_subject(const Chart& chart, const Equations::Conflict& conflict);

/// Pairs of transitions with a common upstream step, in order.
std::vector<std::pair<Id<Chart::Transition>, Id<Chart::Transition>>> branches(const Chart& chart);

}  // namespace grafverif::analysis
