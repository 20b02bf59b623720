// SPDX-License-Identifier: MIT
// Steps as a relation: what each bit of a state becomes, and where sets of states lead and come from.
//
// A bit has a variable before a step and, right below it in the order, one after it. The relation is kept in parts, so
// that no diagram of all of it is ever built; an image quantifies a variable together with the last part that reads it
// (Burch, Clarke and Long 1991).
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
    /// Of the steps of all `bits`; `offered`: what else is true of the variables before each step.
    Relation(const BddSpace& space, std::vector<NextBit> bits, const Bdd& offered = Bdd::constant(true));

    /// Variables that an image quantifies.
    struct Quantified {
        Bdd unread = {};              ///< those that no part reads
        std::vector<Bdd> ended = {};  ///< per part: those that no later one reads
    };
    Quantified quantified(std::span<const std::uint32_t> variables) const;

    /// Where a step leads from `from`; the variables that are quantified, all bits among them, mean nothing there. What
    /// bits become is told by their variables before a step.
    Bdd image(const Bdd& from, const Quantified& variables) const;
    /// From where a step leads to `to`, a function of bits alone; with what it chooses there.
    Bdd preimage(const Bdd& to) const;

    /// In increasing order.
    const std::vector<NextBit>& bits() const { return bits_; }

private:
    struct Part {
        Bdd relation = {};
        Bdd after = {};  ///< its variables after a step
    };

    const BddSpace& space_;
    std::vector<NextBit> bits_ = {};
    std::vector<Part> parts_ = {};
    BddRenaming to_before_, to_after_;
};

}  // namespace grafverif::bdd
