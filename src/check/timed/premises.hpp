// SPDX-License-Identifier: MIT
// What a part of a network must be for others to be judged without it (docs/engines.md, "Sub-loops"), read off the
// graph of a search that came to its end.
#pragma once

#include "check/timed/explore.hpp"
#include "check/timed/graph.hpp"

namespace grafverif::timed {

/// `settled`: the code of Network::settled, or Program::no.
Premises premises_of(Graph& graph, std::uint32_t settled, const Limits& limits);

}  // namespace grafverif::timed
