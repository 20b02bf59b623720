// SPDX-License-Identifier: MIT
// The shortest change of a run of a chart that nobody drives and that does not become stable in its last instant (analyse,
// `total-instability`): the fewest of the changes of its inputs without which each of its instants ends. What an input
// changes, and what comes of the others, is as in explain/inputs.hpp, instant by instant; times pass as they did. It is made
// by the interpreter of the rules.
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
    std::size_t events = 0;                                       ///< how many changes of inputs there are
    std::optional<std::vector<ChartRun::LeftOut>> left_out = {};  ///< of the smallest sets one that changes late
    std::size_t tried = 0;                                        ///< sets
    bool exhausted = false;  ///< the effort allowed is spent, and there were more to try
};

/// `run`: of `chart`, as the evidence of `analyse` is. `effort`: about so many evolutions are made in all.
InstantChange fewest_changes(const Chart& chart, ExecutionMode mode, const ChartRun& run, std::size_t effort = 20'000,
                             const StopAsked& stopped = {});

}  // namespace grafverif
