// SPDX-License-Identifier: MIT
// observe: adds an observer to a Network for each of its selected watched properties.
//
// An observer is a process that reads every state of the loop exactly once, in order, starting at power-on. Every edge
// of the loop sets the flag `look`, edges of the loop are disabled until all observers have read the state, and reading
// is urgent. The runs of the loop are unchanged: an observer never blocks and assigns no variable that the loop reads,
// and the number of moves between two states of the loop equals the number of observers.
//
//   `p leads to q within 20s`    idle -> due    it reads a state with p and without q, and starts its clock
//                                due -> idle    it reads a state with q
//                                due -> failed  its clock exceeds 20 s, at any time: the property is `never failed`
//
// `at stable`: states that are not quiescent are skipped. A liveness property, such as `inevitable p after r`, becomes
// a `leads to` between locations of the observer. Guards can read only variables. Therefore operands read a variable
// `at_NAME` in place of the location of another process, which writes the variable on each edge.
#pragma once

#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Determines if the network also gets the probes that decide the vacuity of its observed properties
/// (compose/vacuity.hpp).
enum class Vacuity { Ignored, Probed };

/// Returns the properties with Pattern::Watched, in order.
std::vector<Id<Property>> watched(const Network& network);

/// Returns `network` with the observers of `chosen`. Each of these properties is replaced by a property of its
/// observer, at the same index. Other watched properties are omitted; all other elements are unchanged. Processes,
/// variables and locations keep their indices. New ones are appended, and probes follow all other properties. Requires
/// verify(network).empty().
Network observed(const Network& network, const std::vector<Id<Property>>& chosen, Vacuity vacuity = Vacuity::Ignored);

}  // namespace grafverif
