// SPDX-License-Identifier: MIT
// StateSpace: represents the states and steps of a FlatSystem by binary decision diagrams. A state is an assignment to
// the variables of a BddSpace; the steps are a relation between assignments.
//
// Each bit of a state variable with a next value has two variables: one for the bit before a step and one for the bit
// after the step. Free variables and choices have one variable, since the value of a free variable after a step is
// arbitrary.
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

/// An assignment to all variables of the space. Only the values of state variables are relevant.
using State = std::vector<bool>;

class StateSpace {
public:
    /// Builds the model. If `by_kind` is true, the steps are partitioned into clusters by the values of those choices
    /// that determine which bits change.
    StateSpace(const FlatSystem& flat, BddSpace& space, bool by_kind);

    // In this class, a set of states is a Boolean function of the bits of a state. Each such function implies the
    // invariants of the system.
    const Bdd& initial() const { return initial_; }
    const Bdd& invariant() const { return invariant_; }
    /// Returns the successors of `states` by one step.
    Bdd image(const Bdd& states) const { return image(states, steps_); }
    Bdd image(const Bdd& states, const std::deque<bdd::ClusterSteps>& steps) const;
    /// True if the steps are partitioned into several clusters, so that `closure` uses saturation.
    bool has_clusters() const { return steps_.size() > 1; }
    /// Returns the states that are reachable from `states` by any number of steps. If a step can assign a variable a
    /// value outside its range, the result may contain invalid states and their successors.
    Bdd closure(const Bdd& states) const;
    /// Returns the predecessors of `states` by one step.
    Bdd preimage(const Bdd& states) const { return preimage(states, steps_); }
    Bdd preimage(const Bdd& states, const std::deque<bdd::ClusterSteps>& steps) const;
    /// Returns states that some step leaves unchanged. The result may be incomplete, because only clusters whose steps
    /// cannot change any bit are considered.
    Bdd still() const;
    /// Returns the steps that satisfy `condition`, a function of states and choices. The bits `kept`, which are bits of
    /// choices, remain in the images and preimages by these steps; the bits of all other choices are eliminated.
    std::deque<bdd::ClusterSteps> steps_where(const Bdd& condition, const std::vector<std::uint32_t>& kept = {}) const;

    /// Returns a translator of terms over the variables of the system to functions of the bits of a state.
    BddTerms terms() const;

    /// States in which a step assigns a variable an undefined value or a value outside its range.
    struct Leak {
        Id<FlatSystem::Variable> variable = {};
        Bdd states = {};
    };
    std::optional<Leak> leak(const Bdd& states) const;

    /// Returns a state of `states`, which must not be empty. The bits of the result are chosen in the order of the
    /// variables. A bit gets its value in `near` if some state of `states` has this value and agrees with all bits
    /// chosen before.
    State pick(const Bdd& states, const State& near) const;
    Bdd only(const State& state) const;
    /// Returns the state in which the variables have the values `values`.
    State state_of(const std::vector<std::int64_t>& values) const;
    /// Returns the values of all variables. If `next` is not null, the choices have values for which a step from
    /// `state` to `next` satisfies `condition`.
    std::vector<std::int64_t> values(const State& state, const State* next, const Bdd& condition) const;

    /// Returns the variables that represent bits of a state, in increasing order.
    const std::vector<std::uint32_t>& state_bits() const { return state_bits_; }
    std::size_t size() const { return space_.variables(); }

private:
    void add_words();
    void constrain(BddTerms& terms);
    void add_next_bits(BddTerms& terms);

    const FlatSystem& flat_;
    BddSpace& space_;
    const bool by_kind_;
    std::vector<BddWord> words_ = {};  ///< bits of each variable before a step
    std::vector<std::uint32_t> state_bits_ = {}, choice_bits_ = {};
    Bdd initial_ = {}, invariant_ = {};
    /// Conjuncts of a relation between states and choices; the relation contains the choices that are possible in each
    /// state.
    std::vector<Bdd> offered_ = {};
    /// For each state variable: states and choices for which the next value is undefined or outside its range.
    std::vector<Leak> leaks_ = {};
    Bdd choices_ = {}, free_ = {};  ///< sets of variables: the bits of choices and of free variables
    std::vector<bdd::NextBit> next_bits_ = {};
    std::deque<bdd::ClusterSteps> steps_ = {};  ///< steps of each cluster
};

}  // namespace grafverif::symbolic
