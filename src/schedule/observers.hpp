// SPDX-License-Identifier: MIT
// Observers as modules of the TransitionSystem (DESDES06 Fig. 6): in each step, the first edge whose guard holds in the
// state at hand.
#pragma once

#include "schedule/properties.hpp"

namespace grafverif::schedule {

/// Adds every observer of the loop as an instance; `meaning` learns where they are. `when`: the states in which they
/// look; not valid: all.
void add_observers(LoopMeaning& meaning, Id<Expr> when = {});

}  // namespace grafverif::schedule
