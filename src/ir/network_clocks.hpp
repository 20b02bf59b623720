// SPDX-License-Identifier: MIT
// Static clock analysis. A clock belongs to one process, so each process is analysed separately.
//
// At location l, only the constants matter with which a clock can be compared before its next reset. The cap of a clock
// at l is the least value from which on the results of all those comparisons are constant: c for `clock >= c`, c + 1
// for `clock <= c` and `clock == c`. Larger values are replaced by the cap. A clock that is not compared before its
// next reset is dead and kept at 0. Both reductions are exact: the merged states have the same moves, delays included,
// into merged states.
//
// A clock is bounded at l if an invariant can bound it before its next reset.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// A closed interval of clock values; strict relations are converted to the integer ones (`c < 3` is `c <= 2`).
struct ClockInterval {
    std::int64_t low = 0;
    std::int64_t high = unbounded;
    static constexpr std::int64_t unbounded = std::int64_t{1} << 48;  ///< greater than every constant
    bool contains(std::int64_t value) const { return low <= value && value <= high; }
};

/// The values in the given relation to `bound`.
ClockInterval admitted(Op relation, std::int64_t bound);
/// The values that a constraint admits.
ClockInterval admitted(const Network& network, const Network::ClockConstraint& constraint);
/// Intersection of `constraints` per clock, `clocks` entries.
std::vector<ClockInterval> admitted(const Network& network, const std::vector<Network::ClockConstraint>& constraints,
                                    std::size_t clocks);

struct ProcessClocks {
    static constexpr std::int64_t dead = -1;
    std::vector<std::vector<std::int64_t>> cap = {};  ///< per location and clock; `dead`: kept at 0
    std::vector<std::vector<bool>> bounded = {};      ///< per location and clock
    std::vector<std::int64_t> greatest = {};          ///< per clock: maximum over all locations, the range to be stored
};

bool resets(const Network::Edge& edge, Id<Network::Clock> clock);

/// Results per process of an expanded network.
std::vector<ProcessClocks> analyse_clocks(const Network& network);

}  // namespace grafverif
