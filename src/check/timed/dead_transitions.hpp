// SPDX-License-Identifier: MIT
// Dead transitions after the point of no return: transitions that are never cleared in the states that are still
// reachable.
#pragma once

#include <cstdint>
#include <string>

#include "check/timed/explore.hpp"
#include "check/timed/graph.hpp"

namespace grafverif::timed {

/// Lists them, each with the part of its condition that is constantly false, if that is a step or a variable. Requires
/// that every reachable state was expanded. Empty if there are none.
std::string dead_transitions_note(Graph& graph, std::uint32_t from, const Limits& limits);

}  // namespace grafverif::timed
