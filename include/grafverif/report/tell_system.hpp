// SPDX-License-Identifier: MIT
// tell: a run of a TransitionSystem -> a Trace, in the words of the charts; a verb.
//
// A step of the system is told as what it did, in this order: the controllers that made an evolution, with the inputs
// they found; timers that ended; components that moved; inputs that changed by themselves. Who did nothing that can be
// seen is not told. Moments are numbers of steps, or times where the system ticks.
#pragma once

#include "grafverif/ir/flat_system.hpp"
#include "grafverif/ir/trace.hpp"
#include "grafverif/report/tell.hpp"

namespace grafverif {

/// Requires that `run` is one of `system`.
Trace tell(const TransitionSystem& system, const SystemRun& run, Detail detail = Detail::Chart);

}  // namespace grafverif
