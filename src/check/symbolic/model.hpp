// SPDX-License-Identifier: MIT
// A FlatSystem over the variables of a BddSpace: its states as assignments, its steps as a relation.
//
// Each bit of a state variable with a next value has two variables, for the bit before and after a step. Free variables
// and choices have one: what a step gives a free variable nobody decides.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bdd/relation.hpp"
#include "bdd/terms.hpp"
#include "ir/flat_system.hpp"

namespace grafverif::symbolic {

/// An assignment to all variables of the space; only those of states count.
using State = std::vector<bool>;

class StateSpace {
public:
    StateSpace(const FlatSystem& flat, BddSpace& space);

    /// States, here and below, are functions of the bits of a state, and imply the invariants.
    const Bdd& initial() const { return initial_; }
    const Bdd& invariant() const { return invariant_; }
    /// The states that a step leads to from one of `states`.
    Bdd image(const Bdd& states) const;
    /// The states from which some step leads to one of `states`.
    Bdd preimage(const Bdd& states) const;

    /// Terms over the variables of the system as functions of the bits of a state.
    BddTerms terms() const;

    /// Where in `states` a step gives some variable a value outside its range, or none; and which.
    struct Leak {
        Id<FlatSystem::Variable> variable = {};
        Bdd states = {};
    };
    std::optional<Leak> leak(const Bdd& states) const;

    /// One of `states`, which are some: as many bits as may be are those of `near`, the others false.
    State pick(const Bdd& states, const State& near) const;
    Bdd only(const State& state) const;
    /// The values of all variables, choices those of a step from `state` to `next`, if one is given.
    std::vector<std::int64_t> values(const State& state, const State* next) const;

    /// The bits of a state, increasing.
    const std::vector<std::uint32_t>& state_bits() const { return state_bits_; }
    std::size_t size() const { return space_.variables(); }

private:
    void add_words();
    void constrain(BddTerms& terms);
    void add_steps(BddTerms& terms);

    const FlatSystem& flat_;
    BddSpace& space_;
    std::vector<BddWord> words_ = {};  ///< per variable: its bits before a step
    std::vector<std::uint32_t> state_bits_ = {}, choice_bits_ = {};
    Bdd initial_ = {}, invariant_ = {};
    std::vector<Bdd> offered_ = {};               ///< choices that a state offers: conjuncts over both
    std::vector<Leak> leaks_ = {};                ///< over states and choices
    Bdd choices_ = {}, free_ = {};                ///< sets of variables
    std::optional<bdd::Relation> relation_ = {};  ///< its steps
    bdd::Relation::Quantified stepped_ = {};      ///< choices, and what is before a step
};

}  // namespace grafverif::symbolic
