// SPDX-License-Identifier: MIT
// Refutations of clauses: proofs in LRAT (Cruz-Filipe, Heule, Hunt, Kaufmann and Schneider-Kamp 2017: "Efficient
// certified RAT verification"), which small, verified programs check.
//
// CaDiCaL 1.5 writes proofs in the format DRAT, which does not list the clauses from which each clause follows. This
// module determines these clauses by unit propagation. It omits each clause of the proof that the refutation does not
// need.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/pdr/solver.hpp"

namespace grafverif::pdr {

/// A set of clauses over the variables 1, ..., `variables`. A negative number represents a negated variable, as in the
/// format DIMACS.
struct Clauses {
    int variables = 0;
    std::vector<std::vector<int>> list = {};
};

/// Returns the clauses in the format DIMACS.
std::string dimacs(const Clauses& clauses);

/// Returns a refutation of the clauses in the format LRAT, or nullopt if the clauses are satisfiable. Throws Exhausted
/// if a limit is exceeded, and std::logic_error if a clause of the solver's proof does not follow by unit propagation.
std::optional<std::string> refutation(const Clauses& clauses, LimitMonitor& watch);

}  // namespace grafverif::pdr
