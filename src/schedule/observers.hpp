// SPDX-License-Identifier: MIT
// Translates observers to modules of the TransitionSystem (DESDES06 Fig. 6). In each step, an observer takes its first
// edge with a guard that holds in the current state.
#pragma once

#include "schedule/properties.hpp"

namespace grafverif::schedule {

/// Adds every observer of the loop as an instance, and records the location symbols of the observers in `meaning`. The
/// observers take edges only in states in which `when` holds; if `when` is invalid, they take edges in all states.
void add_observers(LoopMeaning& meaning, Id<Expr> when = {});

}  // namespace grafverif::schedule
