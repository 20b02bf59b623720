// SPDX-License-Identifier: MIT
// Joins the runs of subsystems that share only time into one run of the complete network. In each instant of the joined
// run, each subsystem makes the same moves as in its separate run. In the joined run, time passes only when all
// subsystems wait.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// `continued` appends no further move to a run with more moves than this number.
constexpr std::size_t most_moves = 100'000;

/// Required states of the subsystems in `others` at the end of `shown` (see `joined`).
enum class Ending {
    /// Any state. A subsystem in `others` makes no moves in the last instant, except at time 0.
    Anywhere,
    Waiting,  ///< the state after all moves of the subsystem in the last instant; required for `at stable`
};

/// Returns the run of the complete network that combines `shown` with `others`, which are infinite runs in which time
/// passes. The moves of all runs refer to processes of the complete network. The result is nullopt if the period of the
/// combined run, the least common multiple of the durations of the repeated moves, is too long.
std::optional<Run> joined(const Run& shown, const std::vector<Run>& others, Ending ending);

/// Appends enabled edges, without delays, to the run. Ends if no edge is enabled, if a state is repeated (the run then
/// has a loop), or if the run has more than `most_moves` moves.
Run continued(const Network& network, Run run);

}  // namespace grafverif
