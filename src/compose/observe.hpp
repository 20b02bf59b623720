// SPDX-License-Identifier: MIT
// observe: adds an observer automaton to a Network for each selected property with Pattern::Watched.
//
// An observer is a process that reads every state of the loop exactly once, in order, starting at power-on. Every edge
// of the loop sets the flag `look`. After such an edge, the edges of the loop are disabled until all observers have
// read the state. The edges by which observers read a state are urgent. The runs of the loop are unchanged, because an
// observer can always read the next state and assigns no variables that the loop reads, except `look`. The number of
// additional moves between two states of the loop is the number of observers.
//
// For example, the property `p leads to q within 20s` becomes `never failed`, and its observer has these edges between
// different locations:
//   `idle -> due`:   The observer reads a state with p and without q, and starts its clock.
//   `due -> idle`:   The observer reads a state with q.
//   `due -> failed`: The edge can be taken at any time when the clock exceeds 20 s.
//
// If the property has the suffix `at stable`, its observer skips the states that are not quiescent. A liveness
// property, such as `inevitable p after r`, becomes a `leads to` between locations of the observer. Guards can read
// only variables, not locations of other processes. Therefore an operand that depends on the location of a process
// reads a variable `at_NAME`, which this process assigns on each edge that changes its location.
#pragma once

#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Determines whether probes for the vacuity of the observed properties are added to the network (compose/vacuity.hpp).
enum class Vacuity { Ignored, Probed };

/// Returns the properties with Pattern::Watched, in order.
std::vector<Id<Property>> watched(const Network& network);

/// Returns `network` with the observers of `chosen`. Each property in `chosen` is replaced by a property of its
/// observer, at the same index. All other properties with Pattern::Watched are omitted; all other elements are
/// unchanged. Processes, variables and locations keep their indices. New processes, variables and locations are
/// appended, and probes follow all other properties. Requires verify(network).empty().
Network observed(const Network& network, const std::vector<Id<Property>>& chosen, Vacuity vacuity = Vacuity::Ignored);

}  // namespace grafverif
