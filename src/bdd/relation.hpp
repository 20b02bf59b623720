// SPDX-License-Identifier: MIT
// Steps as a relation: what each bit of a state becomes, and where sets of states lead and come from.
//
// A bit has a variable before a step and, right below it in the order, one after it. The relation is kept in parts, so
// that no diagram of all of it is ever built; an image quantifies a variable together with the last part that reads it
// (Burch, Clarke and Long 1991). Parts that read one choice are joined and freed of it where that stays small; the
// others come in an order that lets many variables end early and few begin (Ranjan, Aziz, Brayton, Plessier, Pixley
// 1995).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bdd/bdd.hpp"

namespace grafverif::bdd {

/// A bit of a state: its variable before a step, and what it becomes.
struct NextBit {
    std::uint32_t before = 0;
    Bdd value = {};
    std::uint32_t after() const { return before + 1; }
};

class Relation {
public:
    /// Of the steps of all `bits`; other variables stay as they are. `conditions`: what else is true of the variables
    /// before each step; `choices`: those of them that belong to the step.
    Relation(const BddSpace& space, std::vector<NextBit> bits, std::vector<Bdd> conditions = {},
             std::vector<std::uint32_t> choices = {});

    /// Variables that an image quantifies.
    struct Quantified {
        Bdd unread = {};              ///< those that no part reads
        std::vector<Bdd> ended = {};  ///< per part: those that no later one reads
    };
    /// Of `variables` and the choices.
    Quantified quantified(std::span<const std::uint32_t> variables) const;

    /// Where a step leads from `from`; the variables that are quantified, all bits among them, mean nothing there. What
    /// bits become is told by their variables before a step.
    Bdd image(const Bdd& from, const Quantified& variables) const;
    /// From where a step leads to `to`, whatever it chooses.
    Bdd preimage(const Bdd& to) const;

    /// In increasing order.
    const std::vector<NextBit>& bits() const { return bits_; }
    /// The variables before or after a step that it reads or writes, increasing.
    std::vector<std::uint32_t> variables() const;

private:
    struct Part {
        Bdd relation = {};
        std::vector<std::uint32_t> reads = {};  ///< what it depends on, increasing
        Bdd after = {};                         ///< what a preimage quantifies with it
    };

    static Part part(Bdd relation) { return {relation, support(relation), {}}; }
    void free_of_choices();
    void arrange();
    void join();
    void end_after();

    const BddSpace& space_;
    std::vector<NextBit> bits_ = {};
    std::vector<std::uint32_t> choices_ = {};
    std::vector<Part> parts_ = {};
    Bdd unread_after_ = {};  ///< what is after a step and no part reads: it can be anything
    BddRenaming to_before_, to_after_;
};

}  // namespace grafverif::bdd
