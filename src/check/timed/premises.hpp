// SPDX-License-Identifier: MIT
// Premises under which a part (independent subsystem) of a network can be omitted when other parts are checked
// (docs/explanation/decomposition.md, "Sub-loops"). The premises are determined from the graph of a complete search.
#pragma once

#include "check/timed/explore.hpp"
#include "check/timed/graph.hpp"

namespace grafverif::timed {

/// Determines the premises. `quiescent` is the index of the first instruction of the code for Network::settled, or
/// Program::no if the network has no such condition.
Premises premises_of(Graph& graph, std::uint32_t quiescent, const Limits& limits);

}  // namespace grafverif::timed
