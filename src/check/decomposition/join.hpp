// SPDX-License-Identifier: MIT
// Joins runs of subsystems that share only time to one run of the complete network. In each instant of the joined run,
// each subsystem makes the same moves as in its separate run. In the joined run, time passes only when all subsystems
// wait.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// Maximum number of moves of a returned run.
constexpr std::size_t most_moves = 100'000;

/// Required states of the subsystems in `others` at the end of `shown` (see `joined`).
enum class Ending {
    /// Any state; in the last instant, a subsystem has made only the moves without which time could not pass before.
    Anywhere,
    Waiting,  ///< a state in which the subsystem has made all moves of the last instant; required for `at stable`
};

/// Returns the run of the complete network that combines `shown` with `others`, which are infinite runs in which time
/// passes. The moves of all runs refer to processes of the complete network. The result is nullopt if the period of the
/// combined run, the least common multiple of the durations of the repeated moves, is too long.
std::optional<Run> joined(const Run& shown, const std::vector<Run>& others, Ending ending);

/// Continues the run by edges within its last instant. The continuation ends if no edge is enabled, a state is
/// repeated, or the run has more than `most_moves` moves.
Run continued(const Network& network, Run run);

}  // namespace grafverif
