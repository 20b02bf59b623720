// SPDX-License-Identifier: MIT
// Dead transitions: transitions that are never cleared after the point of no return, that is, in the states that are
// reachable from it.
#pragma once

#include <cstdint>
#include <string>

#include "check/timed/explore.hpp"
#include "check/timed/graph.hpp"

namespace grafverif::timed {

/// Returns a note that lists the dead transitions. For each transition, the note names a conjunct of its condition that
/// is constantly false, if this conjunct is a step, a variable or the negation of one. The note is empty if there are
/// no dead transitions. Requires that every reachable state was expanded.
std::string dead_transitions_note(Graph& graph, std::uint32_t from, const Limits& limits);

}  // namespace grafverif::timed
