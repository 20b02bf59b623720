// SPDX-License-Identifier: MIT
// ObservationMap: maps sets of states to the sets of values that a chart observes in these states, and vice versa. An
// observation is a Boolean function of states. A set of observed values ("sights") is a Boolean function with one
// variable per observation. An observation that is a bit of the state is represented by the variable of this bit.
#pragma once

#include <cstdint>
#include <vector>

#include "check/symbolic/model.hpp"

namespace grafverif::supervise {

class ObservationMap {
public:
    /// Creates the map for the observations `seen`. Adds a variable to the space for each observation that is not a bit
    /// of the state.
    ObservationMap(const symbolic::StateSpace& model, BddSpace& space, const std::vector<Bdd>& seen);

    /// `sights` returns the values that are observed in `states`. `states` returns the states in which a value of
    /// `sights` is observed.
    Bdd sights(const Bdd& states) const { return and_exists(states, link_, unseen_); }
    Bdd states(const Bdd& sights) const { return and_exists(sights, link_, own_); }

    /// Returns a literal for each observation: the variable of the observation, and the value that this variable has if
    /// the observation is true.
    const std::vector<BddLiteral>& literals() const { return literals_; }

private:
    std::vector<BddLiteral> literals_ = {};
    Bdd link_ = Bdd::constant(true);
    /// Sets of variables: variables of states that are not observed, and variables that only represent observations.
    Bdd unseen_ = {}, own_ = {};
};

}  // namespace grafverif::supervise
