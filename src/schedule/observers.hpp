// SPDX-License-Identifier: MIT
// Observers as modules of the TransitionSystem (DESDES06 Fig. 6): in each step, the first edge whose guard holds in the
// state at hand.
#pragma once

#include "schedule/properties.hpp"
#include "support/unique_names.hpp"

namespace grafverif::schedule {

/// Every observer of the loop, as an instance; `meaning` learns where they are. `names`: taken in main, `modules`: those
/// of modules. `when`: the states in which they look; not valid: all.
void add_observers(Members& members, LoopMeaning& meaning, UniqueNames& names, UniqueNames& modules, Id<Expr> when = {});

}  // namespace grafverif::schedule
