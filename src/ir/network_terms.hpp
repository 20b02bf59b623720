// SPDX-License-Identifier: MIT
// Function that replaces the terms of a template.
#pragma once

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Replaces each term of `automaton` by `copy(term)`, in order of occurrence.
template <class Copy>
void replace_terms(Network::Template& automaton, Copy&& copy) {
    const auto constraints = [&](std::vector<Network::ClockConstraint>& list) {
        for (Network::ClockConstraint& constraint : list) constraint.bound = copy(constraint.bound);
    };
    const auto assignments = [&](std::vector<Network::Assignment>& list) {
        for (auto& [target, value] : list) {
            target = copy(target);
            value = copy(value);
        }
    };
    for (Network::Location& location : automaton.locations) constraints(location.invariant);
    for (Network::Procedure& procedure : automaton.procedures) assignments(procedure.assignments);
    for (Network::Edge& edge : automaton.edges) {
        edge.guard = copy(edge.guard);
        constraints(edge.constraint);
        assignments(edge.assignments);
    }
}

}  // namespace grafverif
