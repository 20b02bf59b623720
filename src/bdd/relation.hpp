// SPDX-License-Identifier: MIT
// Transition relation: defines the next value of each bit of a state, and computes images and preimages of sets of
// states.
//
// A bit has a variable for its value before a step and, directly below it in the order, a variable for its value after
// the step. The relation is partitioned into conjuncts ("parts") and never represented by one diagram. An image
// quantifies a variable together with the last part that reads it (Burch, Clarke and Long 1991). Parts that read the
// same choice, which is a variable local to one step, are conjoined and the choice is quantified, if the resulting
// diagram is small. The other parts are ordered so that variables can be quantified early and are introduced late
// (Ranjan, Aziz, Brayton, Plessier, Pixley 1995).
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
    /// Represents the steps in which each of `bits` takes its next value; other variables are unchanged. `conditions`
    /// are further constraints on variables before a step and on `choices`, which are variables that are local to a
    /// step.
    Relation(const BddSpace& space, std::vector<NextBit> bits, std::vector<Bdd> conditions = {},
             std::vector<std::uint32_t> choices = {});

    /// Variables that an image quantifies.
    struct Quantified {
        Bdd unread = {};              ///< variables that no part reads
        std::vector<Bdd> ended = {};  ///< for each part: variables that this part reads and no later part reads
    };
    /// Distributes `variables` and the choices over the parts.
    Quantified quantified(std::span<const std::uint32_t> variables) const;

    /// Returns the successors of `from`, in terms of the variables before a step. The quantified `variables` must
    /// include all bits; the result constrains only the next values of bits and the variables that are not quantified.
    Bdd image(const Bdd& from, const Quantified& variables) const;
    /// Returns the states from which a step, with some values of the choices, leads to a state of `to`.
    Bdd preimage(const Bdd& to) const;

    /// Returns the bits, ordered by their variables.
    const std::vector<NextBit>& bits() const { return bits_; }
    /// Returns the variables before or after a step that the relation reads or writes, increasing.
    std::vector<std::uint32_t> variables() const;

private:
    struct Conjunct {
        Bdd relation = {};
        std::vector<std::uint32_t> reads = {};  ///< variables on which the part depends, increasing
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
