// SPDX-License-Identifier: MIT
// Dead transitions of an untimed model: transitions that are never cleared in the states that remain reachable after
// the point of no return.
#pragma once

#include <string>

#include "check/symbolic/model.hpp"

namespace grafverif::symbolic {

/// Returns a note that lists them, each with a conjunct of its condition that is constantly false, if that is a step or
/// a variable. `reached` contains all reachable states; `from` is one of them, the point of no return. Terms are added
/// to `flat`, which belongs to `system`. The note is empty if there are no such transitions, or if the system has no
/// charts.
std::string dead_transitions_note(const TransitionSystem& system, FlatSystem& flat, const StateSpace& model,
                                  const Bdd& reached, const State& from);

}  // namespace grafverif::symbolic
