// SPDX-License-Identifier: MIT
// Searches for the shortest change of a run of a chart without a plant that does not become stable in its last instant
// (finding `total-instability` of analyse): a smallest set of input changes such that each instant of the run without
// these changes ends. Events, and the effect of omitting them, are defined as in explain/inputs.hpp, with instants in
// place of states. The times of the instants are unchanged. The interpreter executes the run without the omitted
// changes.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "explain/smallest.hpp"
#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/execution.hpp"

namespace grafverif {

struct InstantChange {
    std::size_t events = 0;  ///< number of input changes
    std::optional<std::vector<ChartRun::Counterfactual>> left_out =
        {};                 ///< omitted input changes: among all smallest sets, the set whose changes occur latest
    std::size_t tried = 0;  ///< number of sets that were tried

    /// True if the search ended before all sets were tried: it was stopped or reached the maximum effort.
    bool exhausted = false;
};

/// Searches for the shortest change. `run` is a run of `chart` that `analyse` has found. `effort` is the approximate
/// maximum number of evolutions in total.
InstantChange fewest_changes(const Chart& chart, ExecutionMode mode, const ChartRun& run, std::size_t effort = 20'000,
                             const StopRequested& stopped = {});

}  // namespace grafverif
