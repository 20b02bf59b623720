// SPDX-License-Identifier: MIT
// Computes the premises under which a part (independent subsystem) of a network can be omitted when other parts are
// checked (docs/explanation/decomposition.md, "Sub-loops"). The computation uses the graph of a complete search of the
// part.
#pragma once

#include "check/timed/explore.hpp"
#include "check/timed/graph.hpp"

namespace grafverif::timed {

/// Computes the premises for the network of `graph`. `quiescent` is the index of the first instruction of the code for
/// Network::settled, or Program::no if the network has no such condition.
Premises premises_of(Graph& graph, std::uint32_t quiescent, const Limits& limits);

}  // namespace grafverif::timed
