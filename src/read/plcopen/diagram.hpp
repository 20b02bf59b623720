// SPDX-License-Identifier: MIT
// Converts Ladder Diagrams and Function Block Diagrams in PLCopen XML to statements (IEC 61131-3, graphical languages).
//
// A network consists of the elements that are connected without the power rails. Networks are evaluated from top to
// bottom, by the position of their uppermost element. If these positions are equal, the leftmost element decides, then
// the order of the file. Within a network, a coil, an assignment or a call follows the calls whose outputs it reads;
// otherwise the same order applies. A call that reads its outputs reads their values of the previous scan; a longer
// cycle of calls is rejected. If the elements have `executionOrderId`s, these determine the order; if an element reads
// a call that follows it, it reads values of the previous scan.
//
// If a network assigns a variable and reads it in a later statement, its order of evaluation is undefined. The network
// is rejected, unless its elements have ids.
#pragma once

#include <string>
#include <unordered_set>

#include "read/plcopen/network.hpp"

namespace grafverif {

/// Returns the statements of an element `LD` or `FBD`. Edges of contacts and coils add instances to the variables of
/// `unit`. `functions` contains the names of functions of the project, in capital letters.
st::Block statements_of(PlcopenReader& reader, st::Unit& unit, pugi::xml_node diagram,
                        const std::unordered_set<std::string>& functions);

}  // namespace grafverif
