// SPDX-License-Identifier: MIT
// Certificates of unreachability, checked by a solver that does not depend on the search.
#pragma once

#include <string>
#include <vector>

#include "check/pdr/solver.hpp"
#include "circuit/circuit.hpp"

namespace grafverif::pdr {

/// A set of states in which each of these latches has the given value, as increasing literals of latches.
using Cube = std::vector<Literal>;

/// Returns the reason why the complement of the cubes is not an inductive invariant that excludes `bad`, or an empty
/// string if it is one. If it is one, no state with `bad` is reachable: the first state is outside of all cubes, no
/// step leads from outside of all cubes into one, and `bad` is false outside of all cubes. Throws Exhausted.
std::string flaw(const Circuit& circuit, Literal bad, const std::vector<Cube>& cubes, LimitMonitor& watch);

}  // namespace grafverif::pdr
