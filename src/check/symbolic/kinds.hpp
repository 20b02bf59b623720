// SPDX-License-Identifier: MIT
// Kinds of steps: the steps of a system, apart by what they choose, where that tells which bits change. Of a loop whose
// automata take turns: a kind for each that moves, and one for time.
#pragma once

#include <span>
#include <vector>

#include "bdd/relation.hpp"
#include "bdd/terms.hpp"

namespace grafverif::symbolic {

/// Steps of one kind: the bits that they may change, and conjuncts of when they are possible, over states and choices.
struct Kind {
    std::vector<Bdd> conditions = {};
    std::vector<bdd::NextBit> bits = {};
};

/// Kinds that together have the steps of `all`, no more: one by one they may overlap. `choices`: the words chosen anew
/// in each step.
std::vector<Kind> kinds(const BddSpace& space, Kind all, std::span<const BddWord> choices);

}  // namespace grafverif::symbolic
