// SPDX-License-Identifier: MIT
// Families of networks: networks that differ only in the constants of their clock constraints.
//
// A member consists of a frame, which all members share, and one constant per clock constraint. The relaxation of a set
// of members has the same frame. Each constraint of the relaxation admits all clock values that the constraint of some
// member admits. Upper bounds are maxima, lower bounds are minima, and `==` becomes an interval.
//
// Every run of a member is a run of the relaxation. A member and the relaxation have the same initial state. An edge
// that a member can take has the same guard and effect in the relaxation; its constraint and the invariant of its
// target admit the same clock values or more. A delay that is possible in the member is possible in the relaxation:
// invariants admit the same values or more, and urgent edges, which have no clock constraint, are enabled in the same
// states. docs/explanation/parameters.md states and proves which verdicts on the relaxation are also verdicts on its
// members.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "ir/network_clocks.hpp"

namespace grafverif {

/// The constants of all clock constraints of a frame, in the order of the processes. For each process, the constants of
/// the invariants precede the constants of the edges.
using ClockConstants = std::vector<std::int64_t>;

struct FamilyMember {
    Network frame = {};  ///< expanded network in which each clock constraint has the constant 0
    ClockConstants constants = {};
};

/// Splits a network into its frame and its constants. Networks that differ only in the constants of their clock
/// constraints have equal frames. The frame has no named constants (`constants` is empty).
FamilyMember member_of(const Network& network);

/// Returns a copy of `frame` that contains only the property `name`, or no property if `frame` has no property with
/// this name. The results for two frames that differ only in other properties are equal.
Network with_only(const Network& frame, const std::string& name);

/// Returns a hash that is equal for equal frames.
std::uint64_t hash_of(const Network& frame);

/// A relaxation of several members: for each constraint, the least and the greatest constant of the members. For a
/// constraint that is only an upper bound, both values are the greatest constant; for a lower bound, both are the least
/// constant.
struct Relaxation {
    ClockConstants least = {}, greatest = {};
    bool operator==(const Relaxation&) const = default;
    auto operator<=>(const Relaxation&) const = default;

    /// True if the relaxation is the network of the member with these constants.
    bool is_exactly(const ClockConstants& constants) const { return least == constants && greatest == constants; }
};

Relaxation relaxation_of(const Network& frame, const std::vector<const ClockConstants*>& members);

/// Returns the network of one member.
Network network_of(const Network& frame, const ClockConstants& constants);
Network network_of(const Network& frame, const Relaxation& relaxation);

/// Static facts about the clocks of a network, which determine which verdicts on a relaxation are also verdicts on its
/// members.
class ClockFacts {
public:
    explicit ClockFacts(const Network& network);

    /// True if a proof of `no timelock` for `relaxation`, by the conditions of docs/explanation/timed-engine.md
    /// ("Exactness", 4), is also a proof for this member. The result is true if two conditions hold: each edge that
    /// releases a bound of an invariant in the relaxation also releases this bound in the member; and each bound that
    /// is positive in the relaxation is positive in the member.
    bool releases_bounds_of(const ClockFacts& relaxation) const;
    /// True if each edge that is enabled for all sufficiently large clock values in the relaxation is also enabled for
    /// all sufficiently large clock values in this member. Only edges of locations without an invariant are considered.
    bool keeps_edges_of(const ClockFacts& relaxation) const;
    /// True if the network contains a strict clock constraint.
    bool strict() const { return strict_; }

private:
    struct EdgeFacts {
        std::uint64_t frees = 0;  ///< bounds of the source invariant that the edge releases (see EdgeTiming::frees)

        /// True if the source has no invariant and the edge is enabled for all sufficiently large values of all clocks.
        bool at_last = false;
    };
    std::vector<EdgeFacts> edges_ = {};
    std::vector<bool> late_ = {};  ///< per constraint of an invariant: true if the bound is positive
    bool strict_ = false;
};

}  // namespace grafverif
