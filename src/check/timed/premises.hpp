// SPDX-License-Identifier: MIT
// Premises under which a part of a network can be omitted from checks of others (docs/explanation/timed-engine.md,
// "Sub-loops"), determined from the graph of a complete search.
#pragma once

#include "check/timed/explore.hpp"
#include "check/timed/graph.hpp"

namespace grafverif::timed {

/// `settled`: the code of Network::settled, or Program::no.
Premises premises_of(Graph& graph, std::uint32_t settled, const Limits& limits);

}  // namespace grafverif::timed
