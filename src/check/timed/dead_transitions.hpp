// SPDX-License-Identifier: MIT
// Dead transitions: transitions that are never cleared in the states that remain reachable after the point of no
// return.
#pragma once

#include <cstdint>
#include <string>

#include "check/timed/explore.hpp"
#include "check/timed/graph.hpp"

namespace grafverif::timed {

/// Returns a note that lists them, each with a conjunct of its condition that is constantly false, if that is a step or
/// a variable. The note is empty if there are no such transitions. Requires that every reachable state was expanded.
std::string dead_transitions_note(Graph& graph, std::uint32_t from, const Limits& limits);

}  // namespace grafverif::timed
