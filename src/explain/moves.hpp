// SPDX-License-Identifier: MIT
// A run of an untimed model in which plant automata take turns (schedule/network.hpp) as a run of the network that the model
// was made of: each of its steps is an edge of one process, a unit of time, or nothing. So what is found out about runs of a
// network is found out about runs of such a model.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/ir/transition_system.hpp"
#include "grafverif/ir/verdict.hpp"
#include "ir/flat_system.hpp"

namespace grafverif {

/// `network`, which is expanded, as a model without time sees it: clocks have no say.
Network without_clocks(Network network);

struct Moves {
    Run run = {};
    std::vector<std::size_t> steps = {};  ///< per move, the step of the untimed run
};
/// Requires that schedule_network made `system` of this network; where its time is abstract, of that with clocks. Nothing
/// where the run loops, or is none of the network: that breaks off where a value leaves its range or two actions race, and
/// the system goes on.
std::optional<Moves> moves_of(const Network& network, const TransitionSystem& system, const SystemRun& run);

/// Tells in `told`, the projection of the same run, which moves were left out; false, and nothing told: one of them does not show in one moment.
bool mark(const Moves& moves, const std::vector<std::size_t>& left_out, ChartRun& told);

}  // namespace grafverif
