// SPDX-License-Identifier: MIT
// Seen: states as a chart sees them. What it sees are functions of states; a set of sights is a function of a variable
// each, which is the bit of the state where what is seen is that bit.
#pragma once

#include <cstdint>
#include <vector>

#include "check/symbolic/model.hpp"

namespace grafverif::supervise {

class Seen {
public:
    /// Adds variables to the space.
    Seen(const symbolic::StateSpace& model, BddSpace& space, const std::vector<Bdd>& seen);

    /// What is seen of the states; the states that look like one of the sights.
    Bdd sights(const Bdd& states) const { return and_exists(states, link_, unseen_); }
    Bdd states(const Bdd& sights) const { return and_exists(sights, link_, own_); }

    /// The variable of each thing seen, and the value of the variable where it is true.
    const std::vector<BddLiteral>& literals() const { return literals_; }

private:
    std::vector<BddLiteral> literals_ = {};
    Bdd link_ = Bdd::constant(true);
    Bdd unseen_ = {}, own_ = {};  ///< sets of variables: of states and not seen; of sights alone
};

}  // namespace grafverif::supervise
