// SPDX-License-Identifier: MIT
// Random small transition systems with all features of the IR: free variables, choices, bounded integers, definitions,
// an instance, invariants, constraints on steps, justice; and a property of every pattern. They have no intended
// meaning; some have no initial state and some have dead ends.
#pragma once

#include "grafverif/ir/transition_system.hpp"
#include "support/random_chart.hpp"

namespace grafverif {

TransitionSystem random_system(Random& random);

/// True if a symbol of main is a function of states, as properties require, and not of steps: definitions of modules
/// with choices may read them.
bool holds_in_states(const TransitionSystem& system, const TransitionSystem::Symbol& symbol);

/// Adds a property per pattern over the Boolean symbols of main.
void ask_more(TransitionSystem& system, Random& random);

}  // namespace grafverif
