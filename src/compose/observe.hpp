// SPDX-License-Identifier: MIT
// observe: a Network and some of its watched properties -> the Network with an observer beside it for each; a verb, of one
// arrow with compose.
//
// An observer is a process that looks at every state of the loop once, in order, from the one at power-on: the flag `look`
// is set by every edge of the loop, no edge of the loop can fire before all observers have looked, and to look is urgent.
// So the runs of the loop are neither more nor fewer, nor is any other: an observer never blocks, assigns nothing that the
// loop reads, and between two states of the loop there are as many moves as there are observers.
//
//   `p leads to q within 20s`    idle -> due    it looks at a state with p and without q: its clock starts
//                                due -> idle    it looks at a state with q
//                                due -> failed  its clock is beyond 20 s, at any time: the property is `never failed`
//
// `at stable`: what is no settled state is not looked at. Where a question is about what comes in the end (`inevitable p
// after r`), it becomes a `leads to` between locations of the observer. What operands read of where other processes are
// stands in variables `at_NAME`, which these write as they go: guards read variables alone.
#pragma once

#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Whether the network also gets the probes that decide whether its observed properties are vacuous (compose/vacuity.hpp).
enum class Vacuity { Ignored, Probed };

/// The properties of Pattern::Watched, in order.
std::vector<Id<Property>> watched(const Network& network);

/// `network` with the observers of `chosen`, and these properties in the terms of their observers, in their places; the
/// other watched ones are left out, the rest stay as they are. Processes, variables and locations keep their numbers; the
/// new ones are behind them; probes come after all other properties. Requires verify(network).empty().
Network observed(const Network& network, const std::vector<Id<Property>>& chosen, Vacuity vacuity = Vacuity::Ignored);

}  // namespace grafverif
