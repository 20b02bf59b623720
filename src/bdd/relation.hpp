// SPDX-License-Identifier: MIT
// Transition relation: the next value of each bit of a state, with image and preimage of sets of states.
//
// A bit has a variable for its value before a step and, directly below it in the order, a variable for its value after
// the step. The relation is partitioned into conjuncts ("parts") and never represented by one diagram. An image
// quantifies a variable together with the last part that reads it (Burch, Clarke and Long 1991). Parts that
// read the same choice, a variable local to one step, are conjoined and the choice is quantified, if the resulting
// diagram is small. The other parts are ordered so
// that variables can be quantified early and are introduced late (Ranjan, Aziz, Brayton, Plessier, Pixley 1995).
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
    /// Represents the steps of all `bits`; other variables are unchanged. `conditions` are further constraints on the
    /// variables before a step. `choices` are variables among them that are local to a step.
    Relation(const BddSpace& space, std::vector<NextBit> bits, std::vector<Bdd> conditions = {},
             std::vector<std::uint32_t> choices = {});

    /// Variables that an image quantifies.
    struct Quantified {
        Bdd unread = {};              ///< variables that no part reads
        std::vector<Bdd> ended = {};  ///< for each part: variables that it reads and no later part reads
    };
    /// Distributes `variables` and the choices over the parts.
    Quantified quantified(std::span<const std::uint32_t> variables) const;

    /// Returns the successors of `from`. The result does not constrain the quantified variables, which include all
    /// bits. The next values are expressed in the variables before a step.
    Bdd image(const Bdd& from, const Quantified& variables) const;
    /// Returns the predecessors of `to` under any choice.
    Bdd preimage(const Bdd& to) const;

    /// Returns the bits in increasing order.
    const std::vector<NextBit>& bits() const { return bits_; }
    /// Returns the variables before or after a step that the relation reads or writes, increasing.
    std::vector<std::uint32_t> variables() const;

private:
    struct Conjunct {
        Bdd relation = {};
        std::vector<std::uint32_t> reads = {};  ///< variables on which it depends, increasing
        Bdd after = {};                         ///< variables that a preimage quantifies together with it
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
