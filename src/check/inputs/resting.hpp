// SPDX-License-Identifier: MIT
// Checks premises on single processes. If all premises hold, the closed loop has no timelock
// (docs/explanation/input-abstraction.md, "No timelock, no deadlock").
//
// Each process that is not a PLC is examined separately, for all values of the variables that other processes write.
// The state of a process consists of its location and the variables that only this process writes. The premises on a
// process are:
//
//   `bounds`:  In each state of the process without an enabled urgent edge, each bound `c <= d` of the invariant
//              satisfies d >= 1. For each bound, some edge with a true guard is enabled at `c == d` for all values of
//              the other clocks. This edge resets c or leads to a location from which c is not bounded before its next
//              reset.
//   `outputs`: No cycle of urgent edges of the process assigns a variable that a PLC reads, even if variables of other
//              processes change at any time. While the variables of the PLCs are constant, no cycle of urgent edges of
//              the process assigns a variable that another process reads. The processes are examined in sequence. If
//              `outputs` is proved for a process, its variables change only finitely often; therefore these variables
//              are assumed to be constant when later processes are examined.
//   `moves`:   The urgent edges of the process have no cycle while all variables of other processes are constant.
//
// An edge of a timer can *accept a request*. A request is a variable v that only PLCs set to true. The guard of the
// edge has the conjunct `v`, and the edge assigns false to v. An edge that accepts a request is taken at most once per
// cycle of a PLC. Therefore `moves` ignores these edges, and v does not count as an output. Except for requests, no
// process may write a variable that the process reads and that other processes also write.
//
// A further premise, which this file does not check, is that the urgent edges of PLCs and timers have no cycle while
// the inputs of the PLCs are constant. If all premises hold, each sequence of urgent edges is finite. If, in addition,
// the processes without invariants and urgent edges do not move, time passes after each sequence of urgent edges, and
// time diverges.
#pragma once

#include <vector>

#include "check/inputs/process_states.hpp"
#include "ir/network_inputs.hpp"

namespace grafverif {

/// Returns the requests of all timers. Requires that `network` is expanded.
std::vector<TimerRequest> requests_of(const Network& network);

/// True if all processes except PLCs satisfy the premises, and all edges of PLCs are urgent. The result is also false
/// if a process has too many states for this analysis, or can assign a variable a value outside its range. Requires
/// that `network` is expanded and has no observers.
bool lets_time_pass(const Network& network, const InputAblations& ablations = {});

/// True if no process except PLCs can take infinitely many edges that are not urgent in bounded time: each cycle of
/// edges with a non-urgent edge resets a clock and requires that this clock is at least 1. Requires that `network` is
/// expanded and has no observers.
bool takes_time(const Network& network);

}  // namespace grafverif
