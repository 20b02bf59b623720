// SPDX-License-Identifier: MIT
// observe: a Network and some of its watched properties -> the Network with an observer for each. A pass.
//
// An observer is a process that reads every state of the loop exactly once, in order, starting at power-on. Every edge
// of the loop sets the flag `look`, edges of the loop are disabled until all observers have read the state, and reading
// is urgent. The runs of the loop are unchanged: an observer never blocks and assigns no variable that the loop reads,
// and between two states of the loop there are exactly as many moves as observers.
//
//   `p leads to q within 20s`    idle -> due    it reads a state with p and without q: its clock starts
//                                due -> idle    it reads a state with q
//                                due -> failed  its clock exceeds 20 s, at any time: the property is `never failed`
//
// `at stable`: states that are not quiescent are skipped. A liveness property (`inevitable p after r`) becomes a `leads
// to` between locations of the observer. Operands that read locations of other processes read variables `at_NAME`
// instead, which these processes write on each edge, because guards can read only variables.
#pragma once

#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Selects if the network also gets the probes that decide vacuity of its observed properties (compose/vacuity.hpp).
enum class Vacuity { Ignored, Probed };

/// The properties with Pattern::Watched, in order.
std::vector<Id<Property>> watched(const Network& network);

/// `network` with the observers of `chosen`; these properties are replaced by properties of their observers at the same
/// index, other watched properties are omitted, the rest is unchanged. Processes, variables and locations keep their
/// numbers; new ones are appended, and probes come after all other properties. Requires verify(network).empty().
Network observed(const Network& network, const std::vector<Id<Property>>& chosen, Vacuity vacuity = Vacuity::Ignored);

}  // namespace grafverif
