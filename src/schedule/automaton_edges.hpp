// SPDX-License-Identifier: MIT
// Expresses an edge of an automaton by terms over the values before the step. For this purpose, the sequential
// assignments of the edge are substituted into each other.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "ir/slots.hpp"
#include "schedule/main.hpp"

namespace grafverif::schedule {

/// Returns the value of `variable` in each location, as in DESDES06 6.2 (`h_c_l := state = left`). Requires that only
/// this process writes the variable. The result is empty if the variable can have different or non-constant values in
/// some location. For unreachable locations, the value is the initial value.
std::optional<std::vector<std::int64_t>> location_values(const Slots& slots, Id<Network::Variable> variable);

struct EdgeValue {
    Id<Network::Variable> variable = {};
    Id<Expr> term = {};
};

struct EdgeTerms {
    Id<Expr> guard = {};                 ///< guard of the edge, without the source location
    std::vector<EdgeValue> values = {};  ///< value of each written variable, except scratch variables
    Id<Expr> guard_fault = {};           ///< condition under which the guard divides by zero
    Id<Expr> fault = {};  ///< condition under which an assignment leaves the range of its target or divides by zero
};

/// Returns the terms of an edge. For each variable, `symbols` contains the symbol of the module `draft` with its value
/// before the step. `name` creates a definition for a value that a later assignment reads.
EdgeTerms edge_terms(const Slots& slots, const Network::Edge& edge,
                     const std::vector<Id<TransitionSystem::Symbol>>& symbols, const Draft& draft,
                     const std::function<Id<Expr>(const EdgeValue&)>& name);

}  // namespace grafverif::schedule
