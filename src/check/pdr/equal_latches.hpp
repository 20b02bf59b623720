// SPDX-License-Identifier: MIT
// Signal correspondence (van Eijk 2000: "Sequential equivalence checking based on structural similarities"): proves by
// induction that some latches of a circuit have equal values in every reachable state. For two systems that store the
// same state, this is a direct proof of their equality. PDR would need an invariant that relates all values of their
// states.
//
// Initially all latches and the constant false form one class. Random runs are used to split the classes. Then a solver
// searches for a step from a state in which the latches of each class are equal to a state in which latches of a class
// differ. Each such step splits the classes. The search ends when there is no such step.
#pragma once

#include <optional>
#include <vector>

#include "check/pdr/certificate.hpp"

namespace grafverif::pdr {

class EqualLatches {
public:
    /// Both arguments must outlive the object.
    EqualLatches(const Circuit& circuit, LimitMonitor& watch);

    /// Returns the unreachable states in which two latches of a class would differ, as the cubes of an inductive
    /// invariant (see flaw). Throws Exhausted; another call continues the search.
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
