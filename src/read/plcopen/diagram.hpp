// SPDX-License-Identifier: MIT
// Converts Ladder Diagrams and Function Block Diagrams in PLCopen XML to statements (IEC 61131-3, graphical languages).
//
// A network consists of elements that are connected with each other by lines, not only through the power rails.
// Networks are evaluated from top to bottom, by the position of their uppermost element. Networks with equal positions
// are ordered by their leftmost elements, and then by the order of the file. Within a network, a coil, an assignment or
// a call follows the calls whose outputs it reads; elements without such a dependency are ordered by position, in the
// same way as networks. If a call reads its own outputs, it reads their values from the previous scan. A longer cycle
// of calls is rejected. If the elements have `executionOrderId`s, these ids determine the order; if an element reads an
// output of a later call, it reads the value from the previous scan.
//
// If a network assigns a variable and reads it in a later statement, the order of evaluation of the network is
// undefined. The network is then rejected, unless its elements have `executionOrderId`s.
#pragma once

#include <string>
#include <unordered_set>

#include "read/plcopen/network.hpp"

namespace grafverif {

/// Returns the statements of an element `LD` or `FBD`. For each contact or coil with the attribute `edge`, an instance
/// of `R_TRIG` or `F_TRIG` is added to the variables of `unit`. `functions` contains the names of functions of the
/// project, in capital letters.
st::Block statements_of(PlcopenReader& reader, st::Unit& unit, pugi::xml_node diagram,
                        const std::unordered_set<std::string>& functions);

}  // namespace grafverif
