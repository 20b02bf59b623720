// SPDX-License-Identifier: MIT
// Observers as modules of the TransitionSystem (DESDES06 Fig. 6). In each step, an observer takes the first edge whose
// guard holds in the current state.
#pragma once

#include "schedule/properties.hpp"

namespace grafverif::schedule {

/// Adds every observer of the loop as an instance, and records their locations in `meaning`. `when` restricts the
/// states in which they take edges; if invalid, they take edges in all states.
void add_observers(LoopMeaning& meaning, Id<Expr> when = {});

}  // namespace grafverif::schedule
