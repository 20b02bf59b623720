// SPDX-License-Identifier: MIT
// Premises on single processes under which a closed loop cannot stop time (docs/explanation/input-abstraction.md, "No
// timelock, no deadlock").
//
// Each process that is not a PLC is examined alone, for all values of the variables that it reads from others. Its
// state consists of its location and the variables that only it writes. The premises:
//
//   bounds    in each state of the process without an enabled urgent edge, each bound `c <= d` of its invariant has
//             d >= 1. For each bound, some edge whose guard is true waits only for c, and resets c or leads to a
//             location from which c is not bounded before its next reset.
//   outputs   no cycle of its urgent edges assigns a variable that a PLC reads, even if all variables of others change
//             at any time; and no such cycle assigns a variable that another process reads, while the variables of the
//             PLCs are constant. The premise is shown for one process after another: the variables of a process for which
//             it has been shown, for all readers, change only finitely often and are assumed constant.
//   moves     its urgent edges have no cycle while all variables of others are constant.
//
// An edge of a timer may accept a request: its guard has the conjunct `v`, and it assigns false to v, which only PLCs
// set to true. Such an edge is taken at most once per cycle of a PLC. Therefore `moves` ignores it, and v is not an
// output. No process writes any other variable that it reads and that others write.
//
// A further premise is that the urgent edges of PLCs and timers have no cycle while the inputs of the PLCs are
// constant. Then no sequence of urgent edges is infinite. If processes without invariants and urgent edges rest, time
// passes after each sequence of urgent edges, and diverges.
#pragma once

#include "ir/network_inputs.hpp"

namespace grafverif {

/// True if all processes except PLCs satisfy the premises, and all edges of PLCs are urgent. Processes that are too
/// large to be examined, or can leave the range of a variable, are not supported: the result is false. Requires that
/// `network` is expanded and has no observers.
bool lets_time_pass(const Network& network, const InputAblations& ablations = {});

/// True if no process except PLCs can take infinitely many edges that are not urgent in bounded time: each cycle with
/// such an edge resets a clock and waits until this clock is at least 1. Has the requirements of lets_time_pass.
bool takes_time(const Network& network);

}  // namespace grafverif
