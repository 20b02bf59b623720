// SPDX-License-Identifier: MIT
// Premises on single processes under which a closed loop cannot stop time (docs/explanation/input-abstraction.md, "No
// timelock, no deadlock").
//
// Each process that is not a PLC is examined alone, for all values of the variables that it reads from others. Its
// state consists of its location and the variables that only it writes. The premises:
//
//   bounds    where it has no enabled urgent edge, each bound `c <= d` of its invariant has d >= 1 and is left by an
//             edge that waits for c alone, and resets c or leaves it unbounded until its next reset.
//   outputs   its urgent edges assign a variable that a PLC reads only finitely often, while all variables of others
//             change at any time; and a variable that another process reads, while those of the PLCs are constant.
//             Variables are constant if the premise, for all readers, has been shown for the process that writes them.
//   moves     while all variables of others are constant, its urgent edges have no cycle.
//
// An edge of a timer may accept a request: it has the guard `v` and assigns false to v, which only PLCs make true. It is
// taken at most once per cycle of a PLC. Therefore `moves` does not count it, and v is not an output. No process
// writes another variable that it reads and that others write.
//
// A further premise is that for constant inputs the urgent edges of PLCs and timers alone have no cycle. Then no
// sequence of urgent edges is infinite. Time passes again, and diverges, if processes without invariants and urgent
// edges rest.
#pragma once

#include "ir/network_inputs.hpp"

namespace grafverif {

/// True if all processes except PLCs satisfy the premises, and all edges of PLCs are urgent. Processes that are too
/// large to be examined, or can leave the range of a variable, are not supported: the result is false. Requires that
/// `network` is expanded and has no observers.
bool lets_time_pass(const Network& network, const InputAblations& ablations = {});

/// True if no process except PLCs can take infinitely many edges that are not urgent in bounded time: each of its cycles
/// with such an edge resets a clock and waits until it is 1. The requirements are the same.
bool takes_time(const Network& network);

}  // namespace grafverif
