// SPDX-License-Identifier: MIT
// Searches through the states of a StateSpace, and the runs that show what they found.
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
    std::vector<Bdd> steps = {};  ///< what holds of the choices of the step that leaves each state; missing: anything
};

/// Adds rings to `rings` until one has a state of `goal` or no new state comes. Rings lie in `within`, which holds the
/// first; or until `goes_on` says no of their number. Whether there may be more.
bool grow(const StateSpace& model, bdd::Rings& rings, const Bdd& within, const Bdd& goal,
          const std::function<bool(std::size_t)>& goes_on = {});

/// A shortest path through `rings` to a state of `goal`; empty where no ring has one.
std::vector<State> shortest_path(const StateSpace& model, const bdd::Rings& rings, const Bdd& goal);

/// The states of `within` from which some path in it, of no step or more, leads to a state of `goal`.
Bdd can_reach(const StateSpace& model, const Bdd& within, const Bdd& goal);
/// The states of `within` from which some infinite path stays in it and meets each of `justice` infinitely often
/// (Emerson and Lei 1986).
Bdd can_stay(const StateSpace& model, const Bdd& within, const std::vector<Bdd>& justice);

/// An infinite path in `staying`, which is a result of can_stay, from its state `first`.
Path stay(const StateSpace& model, const State& first, const Bdd& staying, const std::vector<Bdd>& justice);

FlatRun run_of(const StateSpace& model, const Path& path);

}  // namespace grafverif::symbolic
