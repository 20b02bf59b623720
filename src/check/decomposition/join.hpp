// SPDX-License-Identifier: MIT
// Joins runs of subsystems that share only time to one run of the complete network. In each instant, each subsystem
// behaves as in its separate run. Time passes only when all subsystems wait.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// Maximum number of moves of a returned run.
constexpr std::size_t most_moves = 100'000;

/// Required states of the other subsystems at the end of `shown`.
enum class Ending {
    Anywhere,  ///< any state: a subsystem has only made the moves that were necessary before time could pass
    Waiting,   ///< a state after all moves of the last instant, for `at stable`
};

/// Returns the run of the complete network that combines `shown` with `others`, which are lassos in which time passes.
/// All runs are in terms of the complete network. The result is empty if the period of the combined run would be too
/// long.
std::optional<Run> joined(const Run& shown, const std::vector<Run>& others, Ending ending);

/// Returns the run, continued by edges within its last instant until no edge is enabled, a state is repeated, or there
/// are too many moves.
Run continued(const Network& network, Run run);

}  // namespace grafverif
