// SPDX-License-Identifier: MIT
// Retiming: adapts the delays of a run of one member of a family of networks (ir/network_family.hpp), so that it
// becomes a run of another member.
//
// The edges of the run determine all locations and variables. Only the delays are unknown. Each clock constraint and
// each invariant along the run limits the difference between two points in time. Therefore, the earliest solution is a
// longest path in the graph of these differences. Before the result is used, the simulator of the network semantics
// (ir/network_run.hpp) checks it.
#pragma once

#include <optional>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"
#include "ir/network_family.hpp"

namespace grafverif {

class Retiming {
public:
    /// `run` is a run of `network`, which is a member of the family or a relaxation of members. If `run` is not a run
    /// of `network`, `fit` returns nothing for every member.
    Retiming(const Network& network, const Run& run);

    /// Returns a run of `member` with the same edges as the run of the constructor, or nothing if there is no such run.
    /// Requires that `member` and the network of the constructor have the same frame (ir/network_family.hpp).
    std::optional<Run> fit(const Network& member) const;

private:
    struct Point {
        /// The edge that is taken at this time; empty for the start of the loop and for the end of the run.
        std::optional<Fire> fire = {};
        bool immediate = false;  ///< time does not pass between the previous point and this one
        /// For each process and clock: the point of the last reset before this point.
        std::vector<std::vector<std::size_t>> resets = {};
        std::vector<Id<Network::Location>> locations = {};  ///< locations of the processes before this point
    };
    struct Difference;
    std::vector<Difference> differences(const Network& member) const;

    std::vector<Point> points_ = {};  ///< the points in time of the run; point 0 is power-on
    std::optional<std::size_t> loop_ = {};
};

/// True if `run`, possibly continued by a delay, is a run of `network` and determines the verdict on a property with
/// this pattern. Requires that `run` determines this verdict in another member of the family, and that both members
/// agree on the property. For `inevitable` and `leads to`, the run must be infinite or end in a state without
/// successors. For `no timelock` and `no deadlock`, the run must end in a state without moves. Returns false for
/// patterns whose verdict depends on other runs as well.
bool decides(const Network& network, const Run& run, Pattern pattern);

}  // namespace grafverif
