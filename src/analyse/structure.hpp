// SPDX-License-Identifier: MIT
// What the structure of a chart tells without a search.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif::analysis {

/// Per variable of the chart: whether some equation reads it.
std::vector<bool> variables_read(const Equations& equations);

/// Circles of forcing orders: each forces the partial chart that the next one's step is in, the last the first's.
std::vector<std::vector<Id<Chart::ForcingOrder>>> forcing_cycles(const Chart& chart);

/// Orders on partial charts that an enclosing step governs too, with that step: of the partial chart itself or of one
/// around it.
std::vector<std::pair<Id<Chart::ForcingOrder>, Id<Chart::Step>>> orders_on_enclosed(const Chart& chart);

/// The partial chart that an order of the conflict forces; empty where its order is not found.
std::string conflict_subject(const Chart& chart, const Equations::Conflict& conflict);

/// Transitions that share a step upstream, the first before the second.
std::vector<std::pair<Id<Chart::Transition>, Id<Chart::Transition>>> branches(const Chart& chart);

}  // namespace grafverif::analysis
