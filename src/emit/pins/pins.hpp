// SPDX-License-Identifier: MIT
// Writes a Network as a C file with the partitioned next-state interface (PINS) of LTSmin (A. Blom, J. van de Pol, M.
// Weber: LTSmin: distributed and symbolic reachability, CAV 2010). The multi-core, symbolic and distributed engines of
// LTSmin can explore state spaces that exceed the memory of one machine.
//
// Mapping:
//   location, variable, clock   a slot of the state, if it has at least two values; clocks are capped per location
//                               (ir/network_clocks), so that LTSmin finds the same states as the timed engine
//   edge                        a transition group; it reads the variables of its guard, clock constraint and
//                               assignments
//   a unit of time              the last group; enabled if every invariant holds after the unit and no urgent edge is
//                               enabled
//   state property              a label, true in the states that violate the property (`reachable`: that satisfy it)
//   operands of other properties   labels `NAME_p`, `NAME_q`
//   model error                 the label `breaks_off`: some move would assign a value outside its range, or divide by
//                               zero; such a move has no successor, and a state after a race of stored actions has no
//                               moves
#pragma once

#include <iosfwd>

#include "grafverif/ir/network.hpp"

namespace grafverif::pins {

/// Writes the C file. Requires verify(network).empty().
void emit(const Network& network, std::ostream& out);

}  // namespace grafverif::pins
