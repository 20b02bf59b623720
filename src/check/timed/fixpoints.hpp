// SPDX-License-Identifier: MIT
// Computes fixpoints over the state graph of a search: the states from which a set of states is reachable, or from
// which it is unavoidable.
//
// Each fixpoint is a least set of states that grows backwards along the edges. The computation does not store inverse
// edges. Instead, it sweeps over the undecided states, alternately in increasing and decreasing order. Each sweep adds
// the states whose successors decide that they belong to the fixpoint. Most edges lead to states with greater numbers,
// so a few sweeps suffice. A sweep reads only a bit set and, in sequential order, the links. Therefore a sweep is much
// faster than a depth-first walk. If sweeps add few states, `unavoidable` continues with a depth-first walk, whose cost
// is linear in the size of the graph.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "check/timed/explore.hpp"
#include "check/timed/graph.hpp"

namespace grafverif::timed {

/// Selects transitions of the graph: All (edges and delays), Actions (all edges), or UrgentActions (urgent edges).
enum class Transitions { All, Actions, UrgentActions };

/// Returns the expanded states from which no state of `goal` is reachable by transitions of the set `by`. Adds all
/// other states to `goal`. The result is nullopt if the check was stopped.
std::optional<std::vector<std::uint32_t>> out_of_reach(Graph& graph, StateSet& goal, Transitions by,
                                                       const Limits& limits);

/// Returns true if every maximal run from each state of `roots` reaches `met`, and nullopt if the check was stopped.
/// Adds to `met` those states from which every maximal run reaches `met` and which the computation examined.
std::optional<bool> unavoidable(Graph& graph, StateSet& met, const std::vector<std::uint32_t>& roots,
                                const Limits& limits);

/// A path of states from the initial state, with the index at which its loop begins.
struct Lasso {
    /// If the path has a loop, the first state of the loop is repeated at the end.
    std::vector<std::uint32_t> path = {};
    std::optional<std::size_t> loop = {};
};

/// Returns a short maximal run that visits a state of `roots` and does not visit `met` from this state on. `roots` is
/// in the order of discovery. If `endless` is true, only infinite runs are considered. The path is empty if no run has
/// these properties.
Lasso avoiding(Graph& graph, const StateSet& met, const std::vector<std::uint32_t>& roots, bool endless,
               const Limits& limits);

/// Returns the first state for which `considered` is true and in which no edge is enabled, either immediately or after
/// any delay.
std::optional<std::uint32_t> first_deadlock(const Graph& graph, const std::function<bool(std::uint32_t)>& considered,
                                            const Limits& limits);

}  // namespace grafverif::timed
