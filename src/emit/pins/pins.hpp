// SPDX-License-Identifier: MIT
// Writes a Network as a C file with the partitioned next-state interface (PINS) of LTSmin (Blom, van de Pol and Weber:
// LTSmin: distributed and symbolic reachability, CAV 2010). The multi-core, symbolic and distributed engines of LTSmin
// can explore state spaces that exceed the memory of one machine.
//
// Mapping:
//   location, variable, clock: A slot of the state, if there are at least two values. Clocks are capped per location
//     (ir/network_clocks), so that LTSmin finds the same states as the timed engine.
//   edge: A transition group, which reads the variables of the guard, the clock constraint and the assignments.
//   unit of time: The last group, which is enabled if every invariant holds after the unit and no urgent edge is
//     enabled.
//   state property: A label that is true in the states that violate the property; for `reachable`, in the states that
//     satisfy the condition.
//   any other property: The labels `NAME_p` and `NAME_q` for its operands.
//   model error: The label `breaks_off` is true if some move would assign a value outside its range, or divide by zero.
//     Such a move has no successor, and a state after a race of stored actions has no moves.
#pragma once

#include <iosfwd>

#include "grafverif/ir/network.hpp"

namespace grafverif::pins {

/// Writes the C file. Requires verify(network).empty().
void emit(const Network& network, std::ostream& out);

}  // namespace grafverif::pins
