// SPDX-License-Identifier: MIT
// Fixpoints over the graph of a search: reachable states, unavoidable states, permanent timelocks.
//
// Each is a least set of states that grows backwards along the edges. It is computed without inverse edges, by sweeps
// over the undecided states in alternating directions. Each sweep adds the states that their successors decide. Most
// edges lead to later states, so a few sweeps suffice. A sweep reads links sequentially and a bit set, which is much
// faster than a walk. If sweeps stall, `unavoidable` continues with a depth-first walk, whose cost is linear.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "check/timed/explore.hpp"
#include "check/timed/graph.hpp"

namespace grafverif::timed {

/// Returns the expanded states from which no state of `goal` is reachable by these transitions. Grows `goal` to the
/// complement of the result. The result is empty if the check was stopped.
enum class Transitions { All, Actions, UrgentActions };
std::optional<std::vector<std::uint32_t>> out_of_reach(Graph& graph, StateSet& goal, Transitions by,
                                                       const Limits& limits);

/// Grows `met` to the states from which every maximal run meets it, as far as necessary to decide this for `roots`.
/// Returns true if every maximal run from all roots meets it; empty if the check was stopped.
std::optional<bool> unavoidable(Graph& graph, StateSet& met, const std::vector<std::uint32_t>& roots,
                                const Limits& limits);

/// A maximal run that avoids `met` after one of `roots` (in order of discovery): a short path of states from the
/// initial state, with the index at which its loop begins. If `endless` is true, runs that end are excluded. The path
/// is empty if there is no such run.
struct Lasso {
    std::vector<std::uint32_t> path = {};  ///< if there is a loop, its first state is repeated at the end
    std::optional<std::size_t> loop = {};
};
Lasso avoiding(Graph& graph, const StateSet& met, const std::vector<std::uint32_t>& roots, bool endless,
               const Limits& limits);

/// Returns the first state for which `judged` is true and in which no edge is enabled, immediately or after any delay.
std::optional<std::uint32_t> first_deadlock(const Graph& graph, const std::function<bool(std::uint32_t)>& judged,
                                            const Limits& limits);

}  // namespace grafverif::timed
