// SPDX-License-Identifier: MIT
// Certificates of unreachability, checked by a solver that is independent of the search.
#pragma once

#include <string>
#include <vector>

#include "check/pdr/solver.hpp"
#include "circuit/circuit.hpp"

namespace grafverif::pdr {

/// The states in which each of these latches has the given value: literals of latches, increasing.
using Cube = std::vector<Literal>;

/// The reason why the complement of the cubes is not an inductive invariant that excludes `bad`; empty if it is one.
/// Then no state with `bad` is reachable: the first state is in none of the cubes, no step leads from outside all cubes
/// into one, and outside all cubes `bad` is false. Throws Exhausted.
std::string flaw(const Circuit& circuit, Literal bad, const std::vector<Cube>& cubes, LimitMonitor& watch);

}  // namespace grafverif::pdr
