// SPDX-License-Identifier: MIT
// What is lost behind the point of no return: which transitions are never cleared in the states that can still be reached.
#pragma once

#include <cstdint>
#include <string>

#include "check/timed/explore.hpp"
#include "check/timed/graph.hpp"

namespace grafverif::timed {

/// Names them, each with what stays false of its condition where that is a step or a variable. Requires that every reachable state was
/// looked at. Empty: there is none.
std::string lost_words(Graph& graph, std::uint32_t from, const Limits& limits);

}  // namespace grafverif::timed
