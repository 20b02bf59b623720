// SPDX-License-Identifier: MIT
// Explicit-state search of a TransitionSystem, with verdicts read from its graph: the reference for symbolic engines
// and model checkers. Free variables and choices take every value in every step.
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
    std::size_t initial = 0;  ///< the first states, in number
    bool total = true;        ///< every state has a successor

    std::vector<std::size_t> distances() const;  ///< per state, in steps from the initial ones
};

/// Every reachable state; empty optional: more than `limit` states, or more than `most_paths` steps from one state.
std::optional<SystemGraph> explored(const TransitionSystem& system, std::size_t limit, std::size_t most_paths = 64);

/// One entry per state of a graph.
using StateSet = std::vector<bool>;

StateSet where(const SystemGraph& graph, const std::function<bool(const SystemState&)>& holds);
/// The operands of a property as sets of states, `at stable` resolved; for `always` and `exactly one of` the states
/// that violate it.
std::vector<StateSet> operand_sets(const TransitionSystem& system, const SystemGraph& graph, const Property& property);
/// The states of `within` from which an infinite path stays in it and visits each of `justice` infinitely often.
StateSet fairly_staying(const SystemGraph& graph, const StateSet& within, const std::vector<StateSet>& justice);
std::vector<StateSet> justice_sets(const TransitionSystem& system, const SystemGraph& graph);

/// As check/symbolic.hpp defines the patterns. Requires that the system is total.
bool explicit_verdict(const TransitionSystem& system, const SystemGraph& graph, const Property& property);

}  // namespace grafverif
