// SPDX-License-Identifier: MIT
// Dead transitions after the point of no return of an untimed model: transitions that are never cleared in the states
// that are still reachable.
#pragma once

#include <string>

#include "check/symbolic/model.hpp"

namespace grafverif::symbolic {

/// Lists them, each with the part of its condition that is constantly false, if that is a step or a variable.
/// `reached`: all reachable states; `from`, one of them: the point of no return. `flat`, of `system`, gains terms.
/// Empty if there are none, or if the system has no charts.
std::string dead_transitions_note(const TransitionSystem& system, FlatSystem& flat, const StateSpace& model,
                                  const Bdd& reached, const State& from);

}  // namespace grafverif::symbolic
