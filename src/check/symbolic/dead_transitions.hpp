// SPDX-License-Identifier: MIT
// Finds dead transitions of an untimed model. The *point of no return* is a state from which the states that a property
// requires are unreachable. A transition is *dead* if no state that is reachable from the point of no return has a step
// that clears the transition.
#pragma once

#include <string>

#include "check/symbolic/model.hpp"

namespace grafverif::symbolic {

/// Returns a note that lists the dead transitions. For each dead transition, the note names a conjunct of the
/// transition condition that is always false. The note names only conjuncts that are a step, a variable, or the
/// negation of a step or variable. `reached` contains all reachable states; `from` is the point of no return. Requires
/// that `from` is reachable. The function adds terms to `flat`, which must be the flat system of `system`. The note is
/// empty if there are no dead transitions, or if the system has no charts.
std::string dead_transitions_note(const TransitionSystem& system, FlatSystem& flat, const StateSpace& model,
                                  const Bdd& reached, const State& from);

}  // namespace grafverif::symbolic
