// SPDX-License-Identifier: MIT
// Checks certificates of unreachability with a solver that does not depend on the search.
#pragma once

#include <string>
#include <vector>

#include "check/pdr/solver.hpp"
#include "circuit/circuit.hpp"

namespace grafverif::pdr {

/// A set of states: those in which all of these literals are true. The literals belong to latches and are in increasing
/// order.
using Cube = std::vector<Literal>;

/// Returns the reason why the complement of the cubes is not an inductive invariant that excludes `bad`. If the result
/// is an empty string, no state in which `bad` is true is reachable: the first state is outside of all cubes, no step
/// leads from outside of all cubes into a cube, and `bad` is false outside of all cubes. Throws Exhausted.
std::string flaw(const Circuit& circuit, Literal bad, const std::vector<Cube>& cubes, LimitMonitor& watch);

}  // namespace grafverif::pdr
