// SPDX-License-Identifier: MIT
// Reachability searches in a StateSpace, and runs that show their results.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bdd/rings.hpp"
#include "check/symbolic/model.hpp"

namespace grafverif::symbolic {

/// A run as states of the model.
struct Path {
    std::vector<State> states = {};
    std::optional<std::size_t> loop = {};
    std::vector<Bdd> steps = {};  ///< condition on the choices of the step that leaves each state; missing: none
};

/// Adds rings to `rings` until one intersects `goal`, no new state is found, or `goes_on` returns false for their
/// number. Rings are subsets of `within`, which contains the first. True if there may be further states.
bool grow(const StateSpace& model, bdd::Rings& rings, const Bdd& within, const Bdd& goal,
          const std::function<bool(std::size_t)>& goes_on = {});

/// A shortest path through `rings` to a state of `goal`; empty if no ring contains one.
std::vector<State> shortest_path(const StateSpace& model, const bdd::Rings& rings, const Bdd& goal);

/// The states of `within` from which a path in it, possibly of length 0, leads to a state of `goal`.
Bdd can_reach(const StateSpace& model, const Bdd& within, const Bdd& goal);
/// The states of `within` from which some infinite path stays in it and visits each of `justice` infinitely often
/// (Emerson and Lei 1986).
Bdd can_stay(const StateSpace& model, const Bdd& within, const std::vector<Bdd>& justice);

/// An infinite path in `staying`, which is a result of can_stay, from its state `first`.
Path stay(const StateSpace& model, const State& first, const Bdd& staying, const std::vector<Bdd>& justice);

FlatRun run_of(const StateSpace& model, const Path& path);

}  // namespace grafverif::symbolic
