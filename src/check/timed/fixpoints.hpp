// SPDX-License-Identifier: MIT
// Fixpoints over the graph of a search: reachable states, unavoidable states, permanent timelocks.
//
// Each is a least set of states that grows backwards along the edges. It is computed without inverse edges, by sweeps
// over the open states, from the last to the first and back. Each sweep adds the states that their successors decide.
// Most edges lead to later states, so a few sweeps suffice. A sweep reads links in sequence and a bit set, which is
// much faster than any walk. If sweeps stall, `unavoidable` continues with a depth-first walk, which is linear.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "check/timed/explore.hpp"
#include "check/timed/graph.hpp"

namespace grafverif::timed {

/// The expanded states from which no state of `goal` is reachable by these transitions; `goal` grows to its complement.
/// Empty optional: stopped.
enum class Transitions { All, Actions, UrgentActions };
std::optional<std::vector<std::uint32_t>> out_of_reach(Graph& graph, StateSet& goal, Transitions by,
                                                       const Limits& limits);

/// Grows `met` to the states from which every maximal run meets it, as far as needed to decide this for `roots`. True:
/// it does from all of them. Empty optional: stopped.
std::optional<bool> unavoidable(Graph& graph, StateSet& met, const std::vector<std::uint32_t>& roots,
                                const Limits& limits);

/// A maximal run that avoids `met` from one of `roots` on (in order of discovery), if there is one: a path of states
/// from the initial one, short, with the index at which its loop begins. With `endless`, runs that end do not count,
/// and there may be none: an empty path.
struct Lasso {
    std::vector<std::uint32_t> path = {};  ///< a loop is closed: its first state is repeated at the end
    std::optional<std::size_t> loop = {};
};
Lasso avoiding(Graph& graph, const StateSet& met, const std::vector<std::uint32_t>& roots, bool endless,
               const Limits& limits);

/// The first state that is `judged` and in which no edge is enabled, now or after any delay.
std::optional<std::uint32_t> first_deadlock(const Graph& graph, const std::function<bool(std::uint32_t)>& judged,
                                            const Limits& limits);

}  // namespace grafverif::timed
