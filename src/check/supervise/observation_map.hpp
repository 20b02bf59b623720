// SPDX-License-Identifier: MIT
// Observations of a chart, which are functions of states. A set of observations ("sights") is a function with one
// variable per observation; an observation that is a bit of the state uses the variable of that bit.
#pragma once

#include <cstdint>
#include <vector>

#include "check/symbolic/model.hpp"

namespace grafverif::supervise {

class ObservationMap {
public:
    /// Creates the map and adds variables to the space.
    ObservationMap(const symbolic::StateSpace& model, BddSpace& space, const std::vector<Bdd>& seen);

    /// Return the observations of the states, and the states that have one of the observations.
    Bdd sights(const Bdd& states) const { return and_exists(states, link_, unseen_); }
    Bdd states(const Bdd& sights) const { return and_exists(sights, link_, own_); }

    /// Returns the variable of each observation, with the value at which the observed function is true.
    const std::vector<BddLiteral>& literals() const { return literals_; }

private:
    std::vector<BddLiteral> literals_ = {};
    Bdd link_ = Bdd::constant(true);
    /// Sets of variables: those of states that are not observed; those of observations only.
    Bdd unseen_ = {}, own_ = {};
};

}  // namespace grafverif::supervise
