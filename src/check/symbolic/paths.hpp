// SPDX-License-Identifier: MIT
// Searches of reachable states in a StateSpace, and runs that show the results of these searches.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bdd/rings.hpp"
#include "check/symbolic/model.hpp"

namespace grafverif::symbolic {

/// A run, as states of the model.
struct Path {
    std::vector<State> states = {};
    std::optional<std::size_t> loop = {};
    /// Condition on the choices of the step from each state. If the entry of a step is missing, all choices of the step
    /// are permitted.
    std::vector<Bdd> steps = {};
};

/// Adds rings to `rings` until a ring intersects `goal`, no new state is found, or `keep_going`, which receives the
/// number of rings, returns false. Requires that the first ring is a subset of `within`; all added rings are subsets of
/// `within`. Returns true if further rings may exist.
bool grow(const StateSpace& model, bdd::Rings& rings, const Bdd& within, const Bdd& goal,
          const std::function<bool(std::size_t)>& keep_going = {});

/// Returns a shortest path through `rings` to a state of `goal`, or an empty list if no ring contains such a state.
std::vector<State> shortest_path(const StateSpace& model, const bdd::Rings& rings, const Bdd& goal);

/// Returns the states of `within` from which a path inside `within` leads to a state of `goal`; the path may have
/// length 0.
Bdd can_reach(const StateSpace& model, const Bdd& within, const Bdd& goal);
/// Returns the states of `within` from which some infinite path stays in `within` and visits each set of `justice`
/// infinitely often (Emerson and Lei 1986).
Bdd can_stay(const StateSpace& model, const Bdd& within, const std::vector<Bdd>& justice);

/// Returns an infinite path in `staying` that begins in `first`. Requires that `staying` is a result of can_stay and
/// contains `first`.
Path stay(const StateSpace& model, const State& first, const Bdd& staying, const std::vector<Bdd>& justice);

FlatRun run_of(const StateSpace& model, const Path& path);

}  // namespace grafverif::symbolic
