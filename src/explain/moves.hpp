// SPDX-License-Identifier: MIT
// Converts a run of an untimed model with interleaved plant automata (schedule/network.hpp) to a run of the network
// from which the model was derived. Each step of the run is an edge of one process, a unit of time, or no move.
// After the conversion, analyses of network runs can be applied to the run.
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

/// Returns `network` without clocks, as in the untimed model. Requires that `network` is expanded.
Network without_clocks(Network network);

struct Moves {
    Run run = {};
    std::vector<std::size_t> steps = {};  ///< for each move: index of its step in the untimed run
};
/// Converts the run. Requires that schedule_network derived `system` from this network or, if the time of the system is
/// abstract, from the network with clocks. The result is empty if the run has a loop or is not a run of the network.
/// Not every run of the system is a run of the network: after a value outside its range, or after a race of two
/// actions, the run of the network ends, but the run of the system continues.
std::optional<Moves> moves_of(const Network& network, const TransitionSystem& system, const SystemRun& run);

/// Records the omitted moves in `chart_run`, the projection of the same run. If an omitted move does not correspond to
/// a single event, returns false and changes nothing.
bool mark(const Moves& moves, const std::vector<std::size_t>& left_out, ChartRun& chart_run);

}  // namespace grafverif
