// SPDX-License-Identifier: MIT
// Event clusters: parts of the transition relation whose union is the complete relation (disjunctive partition). Steps
// are grouped by the value of a choice if this value determines which bits of the state can change. An interleaved
// closed loop has one cluster for each automaton and one cluster for time.
#pragma once

#include <span>
#include <vector>

#include "bdd/relation.hpp"
#include "bdd/terms.hpp"

namespace grafverif::symbolic {

/// A cluster of steps: the state bits that the steps may change, and the conjuncts of the condition of the steps, as
/// functions of states and choices.
struct EventCluster {
    std::vector<Bdd> conditions = {};
    std::vector<bdd::NextBit> bits = {};
};

/// Returns clusters whose union is the set of steps of `all`; the clusters may overlap. `choices` are variables whose
/// values are chosen freely in each step.
std::vector<EventCluster> kinds(const BddSpace& space, EventCluster all, std::span<const BddWord> choices);

}  // namespace grafverif::symbolic
