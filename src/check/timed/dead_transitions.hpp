// SPDX-License-Identifier: MIT
// Finds dead transitions. The *point of no return* is a state from which the states that a property requires are
// unreachable. A transition is *dead* if it is never cleared after the point of no return.
#pragma once

#include <cstdint>
#include <string>

#include "check/timed/explore.hpp"
#include "check/timed/graph.hpp"

namespace grafverif::timed {

/// Returns a note that lists the dead transitions; `from` is the point of no return. For each dead transition, the note
/// names a conjunct of the transition condition that is always false. The note names only conjuncts that are a step, a
/// variable, or the negation of a step or variable. The note is empty if there are no dead transitions. Requires that
/// the search has expanded every reachable state.
std::string dead_transitions_note(Graph& graph, std::uint32_t from, const Limits& limits);

}  // namespace grafverif::timed
