// SPDX-License-Identifier: MIT
// Joins runs of subsystems that share only time to one run of the complete network: in each instant each subsystem does
// the same as alone, and all wait for each other before time passes.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// Maximum number of moves of a run.
constexpr std::size_t most_moves = 100'000;

/// Required states of the others at the end of `shown`.
enum class Ending {
    Anywhere,  ///< anywhere: they have moved as far as time required
    Waiting,   ///< they have completed the moves of the last instant, for `at stable`
};

/// The run of the complete network that combines `shown` with `others`, lassos in which time passes; all in terms of
/// the complete network. Empty if its period would be too long.
std::optional<Run> joined(const Run& shown, const std::vector<Run>& others, Ending ending);

/// The run, continued until no move is possible without the passing of time, a state is repeated, or there are too many
/// moves.
Run gone_on(const Network& network, Run run);

}  // namespace grafverif
