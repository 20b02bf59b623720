// SPDX-License-Identifier: MIT
// One edge of an automaton as terms over the values before the step: its assignments, which are sequential, inserted
// into each other.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "ir/slots.hpp"
#include "schedule/main.hpp"

namespace grafverif::schedule {

// Variables that a location tells: DESDES06 6.2 defines `h_c_l := state = left`.

/// Per location the value that `variable`, which only this process writes, has there; empty where some location can be
/// entered with different values, or with one that is no constant. Locations without a way there get the initial value.
std::optional<std::vector<std::int64_t>> location_values(const Slots& slots, Id<Network::Variable> variable);

struct EdgeValue {
    Id<Network::Variable> variable = {};
    Id<Expr> term = {};
};

struct EdgeTerms {
    Id<Expr> guard = {};                 ///< without the location
    std::vector<EdgeValue> values = {};  ///< of each variable written, scratch variables apart
    Id<Expr> guard_fault = {};           ///< the guard divides by zero
    Id<Expr> fault = {};                 ///< some assignment would leave its range, or divide by zero
};

/// `symbols`: per variable the symbol of the module `draft` that holds it before the step. `name`: a definition for a
/// value that a later assignment reads, as a term.
EdgeTerms edge_terms(const Slots& slots, const Network::Edge& edge,
                     const std::vector<Id<TransitionSystem::Symbol>>& symbols, const Draft& draft,
                     const std::function<Id<Expr>(const EdgeValue&)>& name);

}  // namespace grafverif::schedule
