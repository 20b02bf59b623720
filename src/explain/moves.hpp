// SPDX-License-Identifier: MIT
// Converts a run of an untimed model with interleaved plant automata (schedule/network.hpp) to a run of the network
// that the model was derived from: each of its steps is an edge of one process, a unit of time, or no move. So analyses
// of runs of a network apply to runs of such a model.
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

/// `network`, which is expanded, as an untimed model sees it: without clocks.
Network without_clocks(Network network);

struct Moves {
    Run run = {};
    std::vector<std::size_t> steps = {};  ///< per move, the step of the untimed run
};
/// Requires that schedule_network derived `system` from this network or, if its time is abstract, from the one with
/// clocks. Nothing if the run loops, or is not a run of the network: the network aborts if a value leaves its range or
/// two actions race, and the system continues.
std::optional<Moves> moves_of(const Network& network, const TransitionSystem& system, const SystemRun& run);

/// Records the omitted moves in `told`, the projection of the same run; false, without a change, if one of them does
/// not correspond to a single event.
bool mark(const Moves& moves, const std::vector<std::size_t>& left_out, ChartRun& told);

}  // namespace grafverif
