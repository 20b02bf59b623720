// SPDX-License-Identifier: MIT
// Proves `inevitable q` and `p leads to q`, both without a duration, on an abstraction without clocks.
//
// Premises: `no timelock` is proved, and no run has infinitely many moves in bounded time (check/inputs/resting.hpp).
// Therefore time diverges in each maximal run of the loop. Such a run corresponds to a run of the abstraction of one of
// two forms:
//   - The run has a last move, after which no urgent edge is enabled and no bound of an invariant is in force.
//   - The run has infinitely many moves. It does not remain forever in states that all have an enabled urgent edge, and
//     no process stays forever in a location with a bound without moving.
// If no run of these forms avoids q, the property holds.
#pragma once

#include <optional>
#include <vector>

#include "check/inputs/follow.hpp"

namespace grafverif {

struct ResponseResult {
    std::optional<bool> holds = {};  ///< true if proved, false if not; empty if a limit was reached
    bool vacuous = false;            ///< true if the search found no state with p
    std::vector<InputLevel> levels = {};
    std::size_t states = 0;
};

/// Proves `property`, which is a property of `loop`. Requires that `loop` is complete and expanded, and has neither
/// observers nor strict constraints.
ResponseResult prove_response(const Network& loop, const std::vector<AbstractableProcess>& instances,
                              const Property& property, const FollowLimits& limits);

}  // namespace grafverif
