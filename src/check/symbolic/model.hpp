// SPDX-License-Identifier: MIT
// A FlatSystem over the variables of a BddSpace: its states as assignments, its steps as a relation.
//
// Each bit of a state variable with a next value has two variables, for the bit before and after a step. Free variables
// and choices have one: what a step gives a free variable nobody decides.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "bdd/saturation.hpp"
#include "bdd/terms.hpp"
#include "ir/flat_system.hpp"

namespace grafverif::symbolic {

/// An assignment to all variables of the space; only those of states count.
using State = std::vector<bool>;

class StateSpace {
public:
    /// `by_kind`: steps are kept apart by what they choose, where that tells which bits change.
    StateSpace(const FlatSystem& flat, BddSpace& space, bool by_kind);

    /// States, here and below, are functions of the bits of a state, and imply the invariants.
    const Bdd& initial() const { return initial_; }
    const Bdd& invariant() const { return invariant_; }
    /// The states that a step leads to from one of `states`.
    Bdd image(const Bdd& states) const { return image(states, steps_); }
    Bdd image(const Bdd& states, const std::deque<bdd::Steps>& steps) const;
    /// Whether steps are of several kinds; then `closure` is quick.
    bool has_kinds() const { return steps_.size() > 1; }
    /// The states that any number of steps leads to from one of `states`, as long as all values stay in their ranges:
    /// one outside may be among them, with what follows.
    Bdd closure(const Bdd& states) const;
    /// The states from which some step leads to one of `states`.
    Bdd preimage(const Bdd& states) const { return preimage(states, steps_); }
    Bdd preimage(const Bdd& states, const std::deque<bdd::Steps>& steps) const;
    /// States in which some step leaves all as it is, as far as its kind tells.
    Bdd still() const;
    /// The steps of which `condition`, over states and choices, is true. Images and preimages leave the choices `kept`,
    /// bits of the space, as they are.
    std::deque<bdd::Steps> steps_where(const Bdd& condition, const std::vector<std::uint32_t>& kept = {}) const;

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
    /// The state in which the variables have these values.
    State state_of(const std::vector<std::int64_t>& values) const;
    /// The values of all variables, choices those of a step from `state` to `next`, if one is given, of which
    /// `condition` is true.
    std::vector<std::int64_t> values(const State& state, const State* next, const Bdd& condition) const;

    /// The bits of a state, increasing.
    const std::vector<std::uint32_t>& state_bits() const { return state_bits_; }
    std::size_t size() const { return space_.variables(); }

private:
    void add_words();
    void constrain(BddTerms& terms);
    void add_next_bits(BddTerms& terms);

    const FlatSystem& flat_;
    BddSpace& space_;
    const bool by_kind_;
    std::vector<BddWord> words_ = {};  ///< per variable: its bits before a step
    std::vector<std::uint32_t> state_bits_ = {}, choice_bits_ = {};
    Bdd initial_ = {}, invariant_ = {};
    std::vector<Bdd> offered_ = {};  ///< choices that a state offers: conjuncts over both
    std::vector<Leak> leaks_ = {};   ///< over states and choices
    Bdd choices_ = {}, free_ = {};   ///< sets of variables
    std::vector<bdd::NextBit> next_bits_ = {};
    std::deque<bdd::Steps> steps_ = {};  ///< by kind
};

}  // namespace grafverif::symbolic
