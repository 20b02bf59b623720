// SPDX-License-Identifier: MIT
// Static clock analysis. Each process is analysed separately, because a clock belongs to only one process.
//
// At location l, a constant is relevant to a clock only if the clock can be compared with it before its next reset. The
// cap of a clock at l is the least value from which on the results of all these comparisons are constant: c for `clock
// >= c`, c + 1 for `clock <= c` and `clock == c`. Larger values are replaced by the cap. A clock that is not compared
// before its next reset is dead and kept at 0. Both reductions are exact: states that are merged have the same moves,
// including delays, and these moves lead to states that are also merged.
//
// A clock is bounded at l if an invariant can limit it before its next reset.
//
// The constants of lower and of upper bounds are also computed separately. They define which clock values simulate
// others (check/timed/store/covering.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// A closed interval of clock values. Strict relations are converted to non-strict integer relations: `c < 3` becomes
/// `c <= 2`.
struct ClockInterval {
    std::int64_t low = 0;
    std::int64_t high = unbounded;
    static constexpr std::int64_t unbounded = std::int64_t{1} << 48;  ///< a value greater than every constant
    bool contains(std::int64_t value) const { return low <= value && value <= high; }
};

/// Returns the values v for which `v relation bound` is true.
ClockInterval admitted(Op relation, std::int64_t bound);
/// Returns the values that a constraint admits.
ClockInterval admitted(const Network& network, const Network::ClockConstraint& constraint);
/// Returns the intersection of `constraints` per clock; the result has `clocks` entries.
std::vector<ClockInterval> admitted(const Network& network, const std::vector<Network::ClockConstraint>& constraints,
                                    std::size_t clocks);

struct ProcessClocks {
    static constexpr std::int64_t dead = -1;
    std::vector<std::vector<std::int64_t>> cap = {};  ///< cap per location and clock; a `dead` clock is kept at 0
    std::vector<std::vector<bool>> bounded = {};      ///< true if the clock is bounded, per location and clock
    std::vector<std::int64_t> greatest = {};          ///< maximum cap per clock over all locations
    /// Greatest constant d of a comparison `clock >= d` before the next reset, per location and clock; 0 if there is
    /// none. `clock == d` is a comparison with a lower and with an upper bound.
    std::vector<std::vector<std::int64_t>> lower = {};
    /// Greatest constant d of a comparison `clock <= d` before the next reset, per location and clock; `no_upper` if
    /// there is none.
    std::vector<std::vector<std::int64_t>> upper = {};
    static constexpr std::int64_t no_upper = -1;
};

bool resets(const Network::Edge& edge, Id<Network::Clock> clock);

/// The clock values for which an edge is enabled if its guard holds, among all dense values that the invariant of its
/// source permits. The edge depends on a clock if some of these values violate its constraint or, after the resets, the
/// invariant of its target. Bit k belongs to constraint k of the invariant of the source, for k < 63.
struct EdgeTiming {
    std::uint64_t covers = 0;  ///< the edge is enabled at the bound of the constraint, and depends on no other clock
    std::uint64_t frees = 0;   ///< also, the clock of the constraint is reset, or not bounded before its next reset
    bool always = false;       ///< the edge is enabled for all values
    bool at_last = false;      ///< the edge is enabled once every clock is large enough
};

/// `clocks` is the clock analysis of the process. Requires that the network is expanded.
EdgeTiming timing_of(const Network& network, const ProcessClocks& clocks, const Network::Template& automaton,
                     const Network::Edge& edge);

/// Returns the clock analysis of each process of an expanded network.
std::vector<ProcessClocks> analyse_clocks(const Network& network);

}  // namespace grafverif
