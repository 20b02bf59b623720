// SPDX-License-Identifier: MIT
// Refutations of clauses: proofs in LRAT (Cruz-Filipe, Heule, Hunt, Kaufmann and Schneider-Kamp 2017: "Efficient
// certified RAT verification"), which small, verified programs check.
//
// CaDiCaL 1.5 writes proofs in DRAT, without the clauses from which each clause follows. Therefore, unit propagation
// determines these clauses here, and each clause of the proof that the refutation does not need is omitted.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/pdr/solver.hpp"

namespace grafverif::pdr {

/// Clauses over the variables 1..variables; a negative number is an inverted variable, as in DIMACS.
struct Clauses {
    int variables = 0;
    std::vector<std::vector<int>> list = {};
};

/// Returns the clauses in the format DIMACS.
std::string dimacs(const Clauses& clauses);

/// Returns a refutation of the clauses in LRAT, or nothing if the clauses are satisfiable. Throws Exhausted if a limit
/// is exceeded, and std::logic_error if a clause of the solver's proof does not follow by unit propagation.
std::optional<std::string> refutation(const Clauses& clauses, LimitMonitor& watch);

}  // namespace grafverif::pdr
