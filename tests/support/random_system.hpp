// SPDX-License-Identifier: MIT
// Random small transition systems of everything that the IR can say: free variables, choices, bounded integers,
// definitions, an instance, invariants, constraints on steps, justice; and a property of every pattern. They mean
// nothing; some have no initial state and some get stuck.
#pragma once

#include "grafverif/ir/transition_system.hpp"
#include "support/random_chart.hpp"

namespace grafverif {

TransitionSystem random_system(Random& random);

/// Whether a symbol of main holds in states, as properties want it, and not in steps: definitions of modules that offer
/// choices may read them.
bool holds_in_states(const TransitionSystem& system, const TransitionSystem::Symbol& symbol);

/// A property per pattern over the Boolean symbols of main, beside those there are.
void ask_more(TransitionSystem& system, Random& random);

}  // namespace grafverif
