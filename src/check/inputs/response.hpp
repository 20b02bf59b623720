// SPDX-License-Identifier: MIT
// Proves `inevitable q` and `p leads to q` without a bound, on an abstraction without clocks.
//
// The premises: `no timelock` is proved, and no run has infinitely many moves in bounded time (check/inputs/resting.hpp).
// So each maximal run of the loop has infinite time. It corresponds to a run of the abstraction, which therefore has one
// of these forms. After the last move no urgent edge is enabled and no bound of an invariant is in force. Or it has
// infinitely many moves; then it does not remain among states that all have an enabled urgent edge, and no process
// remains in locations with bounds without moving. If no run of these forms avoids q, the property holds.
#pragma once

#include <optional>
#include <vector>

#include "check/inputs/follow.hpp"

namespace grafverif {

struct ResponseResult {
    std::optional<bool> holds = {};  ///< false: not proved. Nothing: a limit is reached
    bool vacuous = false;            ///< holds, and p is never true
    std::vector<InputLevel> levels = {};
    std::size_t states = 0;
};

/// `property`: of `loop`, which is complete, expanded, without observers and strict constraints.
ResponseResult prove_response(const Network& loop, const std::vector<AbstractableProcess>& instances,
                              const Property& property, const FollowLimits& limits);

}  // namespace grafverif
