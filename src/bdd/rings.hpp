// SPDX-License-Identifier: MIT
// Rings: what a breadth-first search of sets has found. Each ring holds the states to which a step leads from the one
// before it and that are in none before; so the first ring with a state of some set has those that are nearest, and a
// shortest path to one goes back through one ring after the other.
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
    Bdd reached = {};  ///< all of them together

    /// Adds the new ones of `states` as a ring; false: there are none.
    bool add(const Bdd& states) {
        const Bdd ring = states & ~reached;
        if (ring.is_false()) return false;
        reached |= ring;
        each.push_back(ring);
        return true;
    }

    /// The first ring with a state of `goal`.
    std::optional<std::size_t> nearest(const Bdd& goal) const {
        if ((reached & goal).is_false()) return {};
        for (std::size_t ring = 0; ring < each.size(); ++ring)
            if (!(each[ring] & goal).is_false()) return ring;
        return {};
    }
};

/// A path to `last` over `steps` rings; `before(k, state)` is a state of ring k from which a step leads to `state`.
template <class State, class Before>
std::vector<State> path_back(std::size_t steps, State last, const Before& before) {
    std::vector<State> path{std::move(last)};
    while (steps-- > 0) path.push_back(before(steps, path.back()));
    std::ranges::reverse(path);
    return path;
}

}  // namespace grafverif::bdd
