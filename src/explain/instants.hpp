// SPDX-License-Identifier: MIT
// The shortest change of an open-loop run of a chart that does not become stable in its last instant (analyse,
// `total-instability`): the smallest set of its input changes without which each of its instants ends. Events, and the
// effect of omitting them, are as in explain/inputs.hpp, instant by instant; times are unchanged. The interpreter
// executes the run.
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
        {};                  ///< of the smallest sets, one with late changes
    std::size_t tried = 0;   ///< number of sets
    bool exhausted = false;  ///< the effort is used up before all sets were tried
};

/// `run`: of `chart`, as found by `analyse`. `effort`: approximate maximum number of evolutions in total.
InstantChange fewest_changes(const Chart& chart, ExecutionMode mode, const ChartRun& run, std::size_t effort = 20'000,
                             const StopRequested& stopped = {});

}  // namespace grafverif
