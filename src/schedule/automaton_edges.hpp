// SPDX-License-Identifier: MIT
// Expresses the guard and the effect of an automaton edge by terms over the values before the step. For this purpose,
// the value of each assignment is substituted into the later assignments of the edge.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "ir/slots.hpp"
#include "schedule/main.hpp"

namespace grafverif::schedule {

/// Returns the value that `variable` has in each location of the process, as in DESDES06 6.2 (`h_c_l := state = left`).
/// Requires that only this process writes the variable. The result is nullopt if the variable can have several values
/// in some location, or a value that is not constant. For unreachable locations, the value is the initial value.
std::optional<std::vector<std::int64_t>> location_values(const Slots& slots, Id<Network::Variable> variable);

struct EdgeValue {
    Id<Network::Variable> variable = {};
    Id<Expr> term = {};
};

struct EdgeTerms {
    Id<Expr> guard = {};                 ///< guard of the edge, without the source location
    std::vector<EdgeValue> values = {};  ///< value of each written variable, except scratch variables
    Id<Expr> guard_fault = {};           ///< condition under which the guard divides by zero
    /// Condition under which an assigned value is outside the range of its target or divides by zero.
    Id<Expr> fault = {};
};

/// Returns the terms of an edge. For each variable of the network, `symbols` contains the symbol of the module `draft`
/// that represents the value before the step. `name` creates a definition for a value that a later assignment reads.
EdgeTerms edge_terms(const Slots& slots, const Network::Edge& edge,
                     const std::vector<Id<TransitionSystem::Symbol>>& symbols, const Draft& draft,
                     const std::function<Id<Expr>(const EdgeValue&)>& name);

}  // namespace grafverif::schedule
