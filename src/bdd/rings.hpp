// SPDX-License-Identifier: MIT
// Rings: layers of a breadth-first search with sets of states. Each ring contains the successors of the previous ring
// that are not in any earlier ring. The first ring that contains a goal state contains the nearest goal states. A
// shortest path to a goal state has one state in each ring, from the first ring to the ring of the goal state.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "bdd/bdd.hpp"

namespace grafverif::bdd {

struct Rings {
    std::vector<Bdd> each = {};
    Bdd reached = {};  ///< union of all rings

    /// Adds a ring with the states of `states` that are not in earlier rings. Returns false and adds no ring if all
    /// states are in earlier rings.
    bool add(const Bdd& states) {
        const Bdd ring = states & ~reached;
        if (ring.is_false()) return false;
        reached |= ring;
        each.push_back(ring);
        return true;
    }

    /// Returns the index of the first ring with a state of `goal`, or nullopt if there is none.
    std::optional<std::size_t> nearest(const Bdd& goal) const {
        if ((reached & goal).is_false()) return {};
        for (std::size_t ring = 0; ring < each.size(); ++ring)
            if (!(each[ring] & goal).is_false()) return ring;
        return {};
    }
};

/// Returns a path to `last` with one state in each of the rings 0 to `steps`. Requires that `last` is in ring `steps`.
/// `before(k, state)` returns a predecessor of `state` in ring k.
template <class State, class Before>
std::vector<State> path_back(std::size_t steps, State last, const Before& before) {
    std::vector<State> path{std::move(last)};
    while (steps-- > 0) path.push_back(before(steps, path.back()));
    std::ranges::reverse(path);
    return path;
}

}  // namespace grafverif::bdd
