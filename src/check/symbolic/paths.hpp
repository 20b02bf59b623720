// SPDX-License-Identifier: MIT
// Searches the reachable states of a StateSpace, and returns runs that demonstrate the results.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bdd/rings.hpp"
#include "check/symbolic/model.hpp"

namespace grafverif::symbolic {

/// A run of the model, as a sequence of states.
struct Path {
    std::vector<State> states = {};
    std::optional<std::size_t> loop = {};
    /// For each state of the path: a condition on the choices of the step from this state. If a step has no entry, all
    /// choices are permitted.
    std::vector<Bdd> steps = {};
};

/// Adds rings (sets of states at the same distance) to `rings`. Ends when a ring intersects `goal`, when no new state
/// is found, or when `keep_going` returns false; the argument of `keep_going` is the number of rings. Requires that the
/// first ring is a subset of `within`; all added rings are also subsets of `within`. Returns true if further rings may
/// exist.
bool grow(const StateSpace& model, bdd::Rings& rings, const Bdd& within, const Bdd& goal,
          const std::function<bool(std::size_t)>& keep_going = {});

/// Returns a shortest path through `rings` to a state of `goal`, or an empty list if no ring contains a state of
/// `goal`.
std::vector<State> shortest_path(const StateSpace& model, const bdd::Rings& rings, const Bdd& goal);

/// Returns the states of `within` from which a path inside `within` leads to a state of `goal`; the path may have
/// length 0.
Bdd can_reach(const StateSpace& model, const Bdd& within, const Bdd& goal);
/// Returns the states of `within` from which some infinite path stays in `within` and visits each set of `justice`
/// infinitely often (Emerson and Lei 1986).
Bdd can_stay(const StateSpace& model, const Bdd& within, const std::vector<Bdd>& justice);

/// Returns an infinite path that begins in `first`, stays in `staying` and visits each set of `justice` infinitely
/// often. Requires that `staying` is a result of can_stay and contains `first`.
Path stay(const StateSpace& model, const State& first, const Bdd& staying, const std::vector<Bdd>& justice);

FlatRun run_of(const StateSpace& model, const Path& path);

}  // namespace grafverif::symbolic
