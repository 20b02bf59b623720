// SPDX-License-Identifier: MIT
// Signal correspondence (van Eijk 2000: "Sequential equivalence checking based on structural similarities"): proves by
// induction that some latches of a circuit have equal values in every reachable state. If two systems represent their
// states by the same values, equal latches prove directly that the systems are equivalent. Without equal latches, PDR
// would need an invariant that relates all values of the two states.
//
// Initially, all latches and the constant false form one class. First, random runs split the classes. Then a SAT solver
// searches for a step after which two latches of a class differ; before the step, the latches of each class must be
// equal. Each step that the solver finds splits the classes. The search ends if the solver proves that no step of this
// kind exists.
#pragma once

#include <optional>
#include <vector>

#include "check/pdr/certificate.hpp"

namespace grafverif::pdr {

class EqualLatches {
public:
    /// Both arguments must outlive the object.
    EqualLatches(const Circuit& circuit, LimitMonitor& watch);

    /// Returns cubes that contain all states in which two latches of a class differ. The complement of the cubes is an
    /// inductive invariant (see `flaw`). Throws Exhausted if a limit is exceeded; the next call continues the search.
    const std::vector<Cube>& cubes();

private:
    void split_by_runs();
    bool split_by_solver();
    template <class Value>
    void split(const Value& value);

    const Circuit& circuit_;
    LimitMonitor& watch_;
    std::vector<std::size_t> class_of_;  ///< class of each latch; 0 if the latch is equal to the constant false
    std::optional<Solver> solver_ = {};
    bool split_by_runs_ = false;
    std::optional<std::vector<Cube>> cubes_ = {};
};

}  // namespace grafverif::pdr
