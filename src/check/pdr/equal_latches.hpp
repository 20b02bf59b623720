// SPDX-License-Identifier: MIT
// Signal correspondence (van Eijk 2000: "Sequential equivalence checking based on structural similarities"): which latches
// of a circuit have equal values in every reachable state, by induction. Two systems side by side that keep the same state
// are proved equal by this at once, and by PDR only with an invariant that relates all values of their state.
//
// Latches start in one class, with the constant false. Random runs split the classes; then a solver looks for a state in
// which all latches of a class are equal and a step to one in which some are not, and that step splits them, until there is
// none.
#pragma once

#include <optional>
#include <vector>

#include "check/pdr/certificate.hpp"

namespace grafverif::pdr {

class EqualLatches {
public:
    /// Both outlive it.
    EqualLatches(const Circuit& circuit, Watch& watch);

    /// States that are never reached because two latches would differ in them: an inductive invariant, see flaw. Throws
    /// Exhausted; called again it continues.
    const std::vector<Cube>& cubes();

private:
    void split_by_runs();
    bool split_by_solver();
    template <class Value>
    void split(const Value& value);

    const Circuit& circuit_;
    Watch& watch_;
    std::vector<std::size_t> class_of_;  ///< per latch; 0: equal to the constant false
    std::optional<Solver> solver_ = {};
    bool split_by_runs_ = false;
    std::optional<std::vector<Cube>> cubes_ = {};
};

}  // namespace grafverif::pdr
