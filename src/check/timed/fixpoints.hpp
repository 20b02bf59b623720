// SPDX-License-Identifier: MIT
// Fixpoints over the graph of a search: reachable states, unavoidable states, permanent timelocks.
//
// Each fixpoint is a least set of states that grows backwards along the edges. The computation does not need inverse
// edges: it sweeps over the undecided states in alternating directions. Each sweep adds the states that are decided by
// their successors. Most edges lead to later states, so a few sweeps suffice. A sweep reads only a bit set and,
// sequentially, the links; this is much faster than a walk. If sweeps stall, `unavoidable` continues with a depth-first
// walk, whose cost is linear.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "check/timed/explore.hpp"
#include "check/timed/graph.hpp"

namespace grafverif::timed {

/// Types of transitions: all (edges and delays), edges, or urgent edges.
enum class Transitions { All, Actions, UrgentActions };

/// Returns the expanded states from which no state of `goal` is reachable by transitions of type `by`. Adds all other
/// states to `goal`. The result is nullopt if the check was stopped.
std::optional<std::vector<std::uint32_t>> out_of_reach(Graph& graph, StateSet& goal, Transitions by,
                                                       const Limits& limits);

/// Adds states to `met` from which every maximal run reaches `met`, as far as necessary to decide this for `roots`.
/// Returns true if every maximal run from all roots reaches `met`; empty if the check was stopped.
std::optional<bool> unavoidable(Graph& graph, StateSet& met, const std::vector<std::uint32_t>& roots,
                                const Limits& limits);

/// A path of states from the initial state, with the index at which its loop begins.
struct Lasso {
    std::vector<std::uint32_t> path = {};  ///< if there is a loop, its first state is repeated at the end
    std::optional<std::size_t> loop = {};
};

/// Returns a short maximal run that avoids `met` after one of `roots`, which are in order of discovery. If `endless` is
/// true, only infinite runs are considered. The path is empty if there is no such run.
Lasso avoiding(Graph& graph, const StateSet& met, const std::vector<std::uint32_t>& roots, bool endless,
               const Limits& limits);

/// Returns the first state for which `considered` is true and in which no edge is enabled, either immediately or after
/// any delay.
std::optional<std::uint32_t> first_deadlock(const Graph& graph, const std::function<bool(std::uint32_t)>& considered,
                                            const Limits& limits);

}  // namespace grafverif::timed
