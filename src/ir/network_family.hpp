// SPDX-License-Identifier: MIT
// Families of networks: networks that differ only in the constants of their clock constraints.
//
// A member is a frame, which all members share, and one constant per clock constraint. The relaxation of a set of
// members is the network of the frame in which each constraint admits what the constraint of any member admits: upper
// bounds are maxima, lower bounds are minima, and `==` becomes an interval.
//
// Every run of a member is a run of the relaxation. The initial states are equal. An edge that a member can take has
// the same guard and effect in the relaxation, and its constraint and the invariant of its target admit more. Time that
// can pass in the member can pass in the relaxation: invariants admit more, and urgent edges, which have no clock
// constraint, are enabled in the same states. docs/explanation/parameters.md states which verdicts follow, with proofs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "ir/network_clocks.hpp"

namespace grafverif {

/// The constants of all clock constraints of a frame: process by process, of the invariants and then of the edges.
using ClockConstants = std::vector<std::int64_t>;

struct FamilyMember {
    Network frame = {};  ///< expanded; its clock constraints have the constant 0
    ClockConstants constants = {};
};

/// Splits a network into its frame and its constants. Networks that differ only in the constants of their clock
/// constraints have equal frames. The frame does not list the constants of the loop.
FamilyMember member_of(const Network& network);

/// Returns the same frame with only the property called `name`, if there is one. The results are
/// equal for frames that differ only in other properties.
Network with_only(const Network& frame, const std::string& name);

/// Returns a hash that is equal for equal frames.
std::uint64_t hash_of(const Network& frame);

/// A relaxation of several members: per constraint, the least and the greatest constant. For a constraint with only an
/// upper (lower) bound, both are the greatest (least) constant.
struct Relaxation {
    ClockConstants least = {}, greatest = {};
    bool operator==(const Relaxation&) const = default;
    auto operator<=>(const Relaxation&) const = default;

    /// True if the relaxation of `frame` is the network of the member itself.
    bool is_exactly(const ClockConstants& constants) const { return least == constants && greatest == constants; }
};

Relaxation relaxation_of(const Network& frame, const std::vector<const ClockConstants*>& members);

/// Returns the network of one member.
Network network_of(const Network& frame, const ClockConstants& constants);
Network network_of(const Network& frame, const Relaxation& relaxation);

/// Static facts about the clocks of a network. They determine which verdicts on a relaxation its members share.
class ClockFacts {
public:
    explicit ClockFacts(const Network& network);

    /// True if a proof of `no timelock` for `relaxation`, by the conditions of docs/explanation/timed-engine.md
    /// ("Exactness", 4), is also a proof for this member: at each bound of an invariant, each edge that releases the
    /// bound in the relaxation also releases it in the member, and bounds that are positive remain positive.
    bool releases_bounds_of(const ClockFacts& relaxation) const;
    /// True if each edge that the relaxation can take once every clock is large enough can also be taken by this member
    /// once every clock is large enough. Only edges of locations without an invariant are considered.
    bool keeps_edges_of(const ClockFacts& relaxation) const;
    /// True if a clock constraint is strict.
    bool strict() const { return strict_; }

private:
    struct EdgeFacts {
        std::uint64_t frees = 0;  ///< bounds of the source that the edge releases (see EdgeTiming)
        bool at_last = false;     ///< the source has no invariant, and the edge is enabled once every clock is large
    };
    std::vector<EdgeFacts> edges_ = {};
    std::vector<bool> late_ = {};  ///< per constraint of an invariant: the bound is positive
    bool strict_ = false;
};

}  // namespace grafverif
