// SPDX-License-Identifier: MIT
// What a static look at each automaton says of its clocks. A clock belongs to one process, so every analysis is
// one of a process alone.
//
// At location l a clock only matters by the constants it can be compared with before its next reset. The cap of a clock
// at l is the least value from which on all those comparisons agree for ever: c for `clock >= c`, one above c for
// `clock <= c` and `clock == c`. Values are cut there; a clock compared with nothing before its next reset is dead and
// kept at 0. Both are exact: the states so joined have the same moves, delays included, into joined states.
//
// A clock is bounded at l when an invariant can bound it before its next reset.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// A closed interval of clock values; strict relations are the integer ones (`c < 3` is `c <= 2`).
struct ClockInterval {
    std::int64_t low = 0;
    std::int64_t high = unbounded;
    static constexpr std::int64_t unbounded = std::int64_t{1} << 48;  ///< beyond every constant
    bool contains(std::int64_t value) const { return low <= value && value <= high; }
};

/// The values that stand so to `bound`.
ClockInterval admitted(Op relation, std::int64_t bound);
/// The values that a constraint admits.
ClockInterval admitted(const Network& network, const Network::ClockConstraint& constraint);
/// The meet of `constraints` per clock, `clocks` entries.
std::vector<ClockInterval> admitted(const Network& network, const std::vector<Network::ClockConstraint>& constraints,
                                    std::size_t clocks);

struct ProcessClocks {
    static constexpr std::int64_t dead = -1;
    std::vector<std::vector<std::int64_t>> cap = {};  ///< per location and clock; `dead`: kept at 0
    std::vector<std::vector<bool>> bounded = {};      ///< per location and clock
    std::vector<std::int64_t> greatest = {};          ///< per clock, over all locations: the values to make room for
};

bool resets(const Network::Edge& edge, Id<Network::Clock> clock);

/// Of each process of an expanded network.
std::vector<ProcessClocks> analyse_clocks(const Network& network);

}  // namespace grafverif
