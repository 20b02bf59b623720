// SPDX-License-Identifier: MIT
// Transition relation: represents steps by the next value of each bit of a state, and computes images and preimages of
// sets of states.
//
// Each bit has two variables: one for its value before a step and, directly below in the variable order, one for its
// value after the step. The relation is partitioned into conjuncts ("parts") and is never represented by a single
// diagram. The computation of an image quantifies each variable together with the last part that reads it (Burch,
// Clarke and Long 1991). A choice is a variable that has a value only within one step. If the resulting diagram is
// small, all parts that read the same choice are conjoined, and the choice is quantified. All remaining parts are
// ordered so that variables can be quantified early and are introduced late (Ranjan, Aziz, Brayton, Plessier, Pixley
// 1995).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bdd/bdd.hpp"

namespace grafverif::bdd {

/// A bit of a state: its variable before a step and its next value.
struct NextBit {
    std::uint32_t before = 0;
    Bdd value = {};
    std::uint32_t after() const { return before + 1; }
};

class Relation {
public:
    /// Represents the steps in which each bit of `bits` takes its next value and all other variables are unchanged.
    /// `conditions` are further constraints on the variables before a step and on `choices`.
    Relation(const BddSpace& space, std::vector<NextBit> bits, std::vector<Bdd> conditions = {},
             std::vector<std::uint32_t> choices = {});

    /// Variables that an image quantifies.
    struct Quantified {
        Bdd unread = {};              ///< variables that no part reads
        std::vector<Bdd> ended = {};  ///< for each part: variables that this part reads and no later part reads
    };
    /// Assigns `variables` and the choices to the parts with which an image quantifies them.
    Quantified quantified(std::span<const std::uint32_t> variables) const;

    /// Returns the successors of `from` as a function of the variables before a step. Requires that the quantified
    /// `variables` include all bits. The result constrains only the bits and the variables that are not quantified.
    Bdd image(const Bdd& from, const Quantified& variables) const;
    /// Returns the states from which a step, with some values of the choices, leads to a state of `to`.
    Bdd preimage(const Bdd& to) const;

    /// Returns the bits, ordered by their variables.
    const std::vector<NextBit>& bits() const { return bits_; }
    /// Returns the variables that the relation reads or writes, before or after a step, in increasing order.
    std::vector<std::uint32_t> variables() const;

private:
    struct Conjunct {
        Bdd relation = {};
        std::vector<std::uint32_t> reads = {};  ///< variables on which the part depends, in increasing order
        Bdd after = {};                         ///< variables that a preimage quantifies together with this part
    };

    static Conjunct part(Bdd relation) { return {relation, support(relation), {}}; }
    void free_of_choices();
    void arrange();
    void join();
    void end_after();

    const BddSpace& space_;
    std::vector<NextBit> bits_ = {};
    std::vector<std::uint32_t> choices_ = {};
    std::vector<Conjunct> parts_ = {};
    Bdd unread_after_ = {};  ///< variables after a step that no part reads and that are therefore unconstrained
    BddRenaming to_before_, to_after_;
};

}  // namespace grafverif::bdd
