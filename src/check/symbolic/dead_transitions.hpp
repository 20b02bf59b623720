// SPDX-License-Identifier: MIT
// Dead transitions of an untimed model: transitions that are never cleared after the point of no return, that is, in
// the states that are reachable from it.
#pragma once

#include <string>

#include "check/symbolic/model.hpp"

namespace grafverif::symbolic {

/// Returns a note that lists the dead transitions. For each transition, the note names a conjunct of its condition that
/// is constantly false, if this conjunct is a step, a variable or the negation of one. `reached` contains all reachable
/// states; `from` is the point of no return, which is a reachable state. The function adds terms to `flat`, which must
/// be the flat system of `system`. The note is empty if there are no dead transitions, or if the system has no charts.
std::string dead_transitions_note(const TransitionSystem& system, FlatSystem& flat, const StateSpace& model,
                                  const Bdd& reached, const State& from);

}  // namespace grafverif::symbolic
