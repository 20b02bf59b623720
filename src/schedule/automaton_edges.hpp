// SPDX-License-Identifier: MIT
// One edge of an automaton as terms over the values before the step: its sequential assignments are substituted into
// each other.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "ir/slots.hpp"
#include "schedule/main.hpp"

namespace grafverif::schedule {

// Variables that are functions of the location: DESDES06 6.2 defines `h_c_l := state = left`.

/// Value of `variable`, which only this process writes, per location. Empty if a location can be entered with different
/// or non-constant values. Unreachable locations get the initial value.
std::optional<std::vector<std::int64_t>> location_values(const Slots& slots, Id<Network::Variable> variable);

struct EdgeValue {
    Id<Network::Variable> variable = {};
    Id<Expr> term = {};
};

struct EdgeTerms {
    Id<Expr> guard = {};                 ///< without the location
    std::vector<EdgeValue> values = {};  ///< of each written variable except scratch variables
    Id<Expr> guard_fault = {};           ///< the guard divides by zero
    Id<Expr> fault = {};                 ///< an assignment would leave its range or divide by zero
};

/// `symbols`: per variable the symbol of the module `draft` that holds it before the step. `name`: creates a definition
/// for a value that a later assignment reads.
EdgeTerms edge_terms(const Slots& slots, const Network::Edge& edge,
                     const std::vector<Id<TransitionSystem::Symbol>>& symbols, const Draft& draft,
                     const std::function<Id<Expr>(const EdgeValue&)>& name);

}  // namespace grafverif::schedule
