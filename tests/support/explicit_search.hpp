// SPDX-License-Identifier: MIT
// Explicit-state search of a TransitionSystem, which computes its graph and determines the verdicts
// from the graph. The search is the reference for symbolic engines and model checkers. Free
// variables and choices take every value in every step.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "support/run_transition_system.hpp"

namespace grafverif {

struct SystemGraph {
    std::vector<SystemState> states = {};
    std::vector<std::vector<std::size_t>> successors = {};
    std::size_t initial = 0;  ///< number of initial states, which are the first in the graph
    bool total = true;        ///< true if every state has a successor

    /// Returns, for each state, the distance in steps from the initial states.
    std::vector<std::size_t> distances() const;
};

/// Returns the graph of all reachable states. Returns nothing if there are more than `limit` states, or more than
/// `most_paths` steps from one state.
std::optional<SystemGraph> explored(const TransitionSystem& system, std::size_t limit, std::size_t most_paths = 64);

/// A set of states, as one entry for each state of a graph.
using StateSet = std::vector<bool>;

StateSet where(const SystemGraph& graph, const std::function<bool(const SystemState&)>& holds);
/// Returns the operands of a property as sets of states, with `at stable` resolved. For `always` and `exactly one of`
/// the result is the set of states that violate the property.
std::vector<StateSet> operand_sets(const TransitionSystem& system, const SystemGraph& graph, const Property& property);
/// Returns the states of `within` from which an infinite path stays in `within` and visits each set of `justice`
/// infinitely often.
StateSet fairly_staying(const SystemGraph& graph, const StateSet& within, const std::vector<StateSet>& justice);
std::vector<StateSet> justice_sets(const TransitionSystem& system, const SystemGraph& graph);

/// True if the property holds, with the definitions of the patterns in check/symbolic/symbolic.hpp. Requires that the
/// system is total.
bool explicit_verdict(const TransitionSystem& system, const SystemGraph& graph, const Property& property);

}  // namespace grafverif
