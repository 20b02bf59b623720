// SPDX-License-Identifier: MIT
// Static clock analysis. Each process is analysed separately, because a clock belongs to only one process.
//
// At location l, a constant is relevant to a clock only if the clock can be compared with the constant before the next
// reset of the clock. The cap of a clock at l is the least value with this property: for all clock values from the cap
// on, each comparison with a relevant constant has the same result. For `clock >= c` the cap is c; for `clock <= c` and
// `clock == c` the cap is c + 1. Clock values above the cap are replaced by the cap. A clock that cannot be compared
// before its next reset is dead; the value of a dead clock is kept at 0. Both reductions are exact: if two states are
// represented by the same reduced state, they have the same moves, including delays, and equal moves lead to states
// that also have the same reduced state.
//
// A clock is bounded at l if an invariant can limit the clock before its next reset.
//
// The greatest relevant constants of lower bounds and of upper bounds are also computed separately. The greatest
// constants determine if a state with one clock value simulates a state with another clock value
// (check/timed/store/covering.hpp).
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
/// Returns the clock values that satisfy `constraint`.
ClockInterval admitted(const Network& network, const Network::ClockConstraint& constraint);
/// Returns the intersection of `constraints` per clock; the result has `clocks` entries.
std::vector<ClockInterval> admitted(const Network& network, const std::vector<Network::ClockConstraint>& constraints,
                                    std::size_t clocks);

struct ProcessClocks {
    static constexpr std::int64_t dead = -1;
    /// Cap of each clock in each location; `dead` if the clock is dead in the location.
    std::vector<std::vector<std::int64_t>> cap = {};
    std::vector<std::vector<bool>> bounded = {};  ///< true if the clock is bounded, per location and clock
    std::vector<std::int64_t> greatest = {};      ///< maximum cap per clock over all locations

    /// Greatest constant d of a comparison `clock >= d` before the next reset, per location and clock; 0 if there is no
    /// such comparison. A comparison `clock == d` is included in `lower` and in `upper`.
    std::vector<std::vector<std::int64_t>> lower = {};
    /// Greatest constant d of a comparison `clock <= d` before the next reset, per location and clock; `no_upper` if
    /// there is no such comparison.
    std::vector<std::vector<std::int64_t>> upper = {};
    static constexpr std::int64_t no_upper = -1;
};

bool resets(const Network::Edge& edge, Id<Network::Clock> clock);

/// Describes the dense clock values for which an edge is enabled if its guard holds. Only values that satisfy the
/// invariant of the source are considered. The edge depends on a clock if some of these values violate the constraint
/// of the edge or, after the resets, the invariant of its target. In `covers` and `frees`, bit k belongs to constraint
/// k of the invariant of the source, for k < 63.
struct EdgeTiming {
    /// Bit k: if the clock is at the bound of constraint k, the edge is enabled for all values of the other clocks.
    std::uint64_t covers = 0;
    /// Bit k: as in `covers`; in addition, the edge resets the clock of constraint k, or no invariant bounds the clock
    /// before its next reset.
    std::uint64_t frees = 0;
    bool always = false;  ///< true if the edge is enabled for all clock values that satisfy the invariant of the source
    bool at_last = false;  ///< true if the edge is enabled for all sufficiently large values of all clocks
};

/// True if the clock constraint of the edge consists only of lower bounds.
bool waits_only(const Network::Edge& edge);

/// `clocks` is the clock analysis of the process. Requires that the network is expanded.
EdgeTiming timing_of(const Network& network, const ProcessClocks& clocks, const Network::Template& automaton,
                     const Network::Edge& edge);

/// Returns the clock analysis of each process of an expanded network.
std::vector<ProcessClocks> analyse_clocks(const Network& network);

}  // namespace grafverif
