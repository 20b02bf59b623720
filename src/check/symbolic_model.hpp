// SPDX-License-Identifier: MIT
// A FlatSystem over the variables of a BddSpace: its states as assignments, its steps as a relation in parts.
//
// Each bit of a state variable with a next value has two variables, the second right below the first, for the bit
// before and after a step. Free variables and choices have one: what a step gives a free variable nobody decides.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/bdd/terms.hpp"
#include "grafverif/ir/flat_system.hpp"

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
    /// A part of the step relation.
    struct Part {
        Bdd relation = {};
        Bdd ended = {};   ///< variables before the step, and choices, that no later part reads
        Bdd after = {};   ///< its variables after the step
    };
    /// The bit of a state variable: what it becomes.
    struct NextBit {
        std::uint32_t before = 0, after = 0;
        Bdd value = {};
    };

    void add_words();
    void constrain(BddTerms& terms);
    void add_next_bits(BddTerms& terms);
    void add_parts();

    const FlatSystem& flat_;
    BddSpace& space_;
    std::vector<BddWord> words_ = {};                 ///< per variable: its bits before a step
    std::vector<std::uint32_t> state_bits_ = {};
    Bdd initial_ = {}, invariant_ = {}, offered_ = {};   ///< offered: choices that a state offers
    std::vector<Leak> leaks_ = {};                    ///< over states and choices
    std::vector<NextBit> next_bits_ = {};
    std::vector<Part> parts_ = {};
    Bdd choices_ = {}, free_ = {}, unread_ = {};      ///< sets of variables; unread: by no part
    std::optional<BddRenaming> to_before_ = {}, to_after_ = {};
};

}  // namespace grafverif::symbolic
