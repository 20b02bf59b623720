// SPDX-License-Identifier: MIT
// Certificates: why a state is never reached, checked by a solver that has seen nothing of the search.
#pragma once

#include <string>
#include <vector>

#include "check/pdr/solver.hpp"
#include "circuit/circuit.hpp"

namespace grafverif::pdr {

/// States in which each of these latches has that value: literals of latches, increasing.
using Cube = std::vector<Literal>;

/// Why the complement of the cubes is no inductive invariant that excludes `bad`; empty: it is one. Then no state with
/// `bad` can be reached: the first state is in none of the cubes, no step leads from outside all of them into one, and
/// outside all of them `bad` is false. Throws Exhausted.
std::string flaw(const Circuit& circuit, Literal bad, const std::vector<Cube>& cubes, Watch& watch);

}  // namespace grafverif::pdr
