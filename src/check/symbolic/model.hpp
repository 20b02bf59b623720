// SPDX-License-Identifier: MIT
// A FlatSystem over the variables of a BddSpace: its states as assignments, its steps as a relation.
//
// Each bit of a state variable with a next value has two variables, for the bit before and after a step. Free variables
// and choices have one, since the value of a free variable after a step is arbitrary.
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

/// An assignment to all variables of the space; only those of states matter.
using State = std::vector<bool>;

class StateSpace {
public:
    /// `by_kind`: partitions the steps by their choices, if these determine which bits change.
    StateSpace(const FlatSystem& flat, BddSpace& space, bool by_kind);

    /// States, here and below, are functions of the bits of a state, and imply the invariants.
    const Bdd& initial() const { return initial_; }
    const Bdd& invariant() const { return invariant_; }
    /// The successors of `states` by one step.
    Bdd image(const Bdd& states) const { return image(states, steps_); }
    Bdd image(const Bdd& states, const std::deque<bdd::ClusterSteps>& steps) const;
    /// True if the steps are partitioned; then `closure` is fast.
    bool has_clusters() const { return steps_.size() > 1; }
    /// The states reachable from `states` by any number of steps, provided that all values stay in their ranges;
    /// otherwise it may contain an invalid state and its successors.
    Bdd closure(const Bdd& states) const;
    /// The predecessors of `states` by one step.
    Bdd preimage(const Bdd& states) const { return preimage(states, steps_); }
    Bdd preimage(const Bdd& states, const std::deque<bdd::ClusterSteps>& steps) const;
    /// States in which some step changes nothing; may miss states if its cluster does not determine that.
    Bdd still() const;
    /// The steps that satisfy `condition`, over states and choices. Images and preimages leave the choices `kept`, bits
    /// of the space, unchanged.
    std::deque<bdd::ClusterSteps> steps_where(const Bdd& condition, const std::vector<std::uint32_t>& kept = {}) const;

    /// Terms over the variables of the system as functions of the bits of a state.
    BddTerms terms() const;

    /// The part of `states` in which a step gives a variable a value outside its range, or an undefined one.
    struct Leak {
        Id<FlatSystem::Variable> variable = {};
        Bdd states = {};
    };
    std::optional<Leak> leak(const Bdd& states) const;

    /// One of `states`, which must not be empty: with as many bits of `near` as possible, the others false.
    State pick(const Bdd& states, const State& near) const;
    Bdd only(const State& state) const;
    /// The state with these values of the variables.
    State state_of(const std::vector<std::int64_t>& values) const;
    /// The values of all variables. The choices are those of a step from `state` to `next`, if one is given, that
    /// satisfies `condition`.
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
    std::deque<bdd::ClusterSteps> steps_ = {};  ///< by cluster
};

}  // namespace grafverif::symbolic
