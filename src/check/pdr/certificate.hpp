// SPDX-License-Identifier: MIT
// Checks certificates of unreachability with a separate SAT solver, which is independent of the solver of the search.
#pragma once

#include <string>
#include <vector>

#include "check/pdr/solver.hpp"
#include "circuit/circuit.hpp"

namespace grafverif::pdr {

/// A cube: a set of states, represented by literals of latches. A state belongs to the cube if all its literals are
/// true in the state. The literals are in increasing order.
using Cube = std::vector<Literal>;

/// Returns the reason why the complement of the cubes is not an inductive invariant that excludes `bad`, or an empty
/// string if the complement is such an invariant. After an empty result, no state in which `bad` is true is reachable:
/// the initial state is outside of all cubes, no step leads from outside of all cubes into a cube, and `bad` is false
/// outside of all cubes. Throws Exhausted if a limit is exceeded.
std::string flaw(const Circuit& circuit, Literal bad, const std::vector<Cube>& cubes, LimitMonitor& watch);

}  // namespace grafverif::pdr
