// SPDX-License-Identifier: MIT
// Network -> a C file with the partitioned next-state interface (PINS) of LTSmin (A. Blom, J. van de Pol, M. Weber:
// LTSmin: distributed and symbolic reachability, CAV 2010): its multi-core, symbolic and distributed engines search what fits
// into no single memory.
//
// What becomes what:
//   location, variable, clock   a slot of the state, where it has two values or more; clocks are cut per location as the
//                               timed engine cuts them (ir/network_clocks), so that the states are the same
//   edge                        a transition group; it reads what its guard, clock constraint and assignments read
//   a unit of time              the last group; it passes where every invariant holds and no urgent edge can fire
//   property about states       a label, true in the states that violate it (`reachable`: that show it)
//   operands of the others      labels `NAME_p`, `NAME_q`
//   break-off                   the label `breaks_off`: some move takes a value out of its range, or divides by zero; such
//                               a move leads nowhere, and no move leaves a state in which stored actions have raced
#pragma once

#include <iosfwd>

#include "grafverif/ir/network.hpp"

namespace grafverif::pins {

/// The C file. Requires verify(network).empty().
void emit(const Network& network, std::ostream& out);

}  // namespace grafverif::pins
