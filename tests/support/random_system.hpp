// SPDX-License-Identifier: MIT
// Generates random small transition systems with all features of the IR: free variables, choices, bounded integers,
// definitions, an instance, invariants, constraints on steps, justice conditions, and a property of every pattern. The
// systems have no intended meaning. Some have no initial state, and some have dead ends.
#pragma once

#include "grafverif/ir/transition_system.hpp"
#include "support/random_chart.hpp"

namespace grafverif {

TransitionSystem random_system(Random& random);

/// True if the value of a symbol of the main module depends only on the state, as properties require, and not on the
/// step. Definitions of modules with choices may depend on the step.
bool holds_in_states(const TransitionSystem& system, const TransitionSystem::Symbol& symbol);

/// Adds a property of each pattern over the Boolean symbols of the main module.
void ask_more(TransitionSystem& system, Random& random);

}  // namespace grafverif
