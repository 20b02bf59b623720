// SPDX-License-Identifier: MIT
// Ladder Diagrams and Function Block Diagrams in PLCopen XML -> statements (IEC 61131-3, graphical languages).
//
// A network consists of the elements that are connected without the power rails. Networks are evaluated from top to
// bottom, by the position of their uppermost element, then of the leftmost, then in the order of the file. Within a
// network, a coil, an assignment or a call follows the calls whose outputs it reads; otherwise the same order applies.
// A call that reads its own outputs reads those of the previous scan; a longer cycle of calls is rejected. If the
// elements have `executionOrderId`s, these alone are the order, and a call that follows is read as of the previous
// scan.
//
// A network that assigns a variable and reads it in a later statement has no defined order of evaluation: it is
// rejected, unless its elements have ids.
#pragma once

#include <string>
#include <unordered_set>

#include "read/plcopen/network.hpp"

namespace grafverif {

/// The statements of an element `LD` or `FBD`. Edges of contacts and coils add instances to the variables of `unit`.
/// `functions`: the names of functions of the project, in capitals.
st::Block statements_of(PlcopenReader& reader, st::Unit& unit, pugi::xml_node diagram,
                        const std::unordered_set<std::string>& functions);

}  // namespace grafverif
