// SPDX-License-Identifier: MIT
// Dead values: previous values of terms (Role::Previous) that a PLC overwrites before anything reads them.
//
// For example, `XP0 && START && !START_previous` reads START_previous only if step P0 is active. The PLC overwrites
// the variable in each cycle. If P0 is not active after a cycle, the value that this cycle stores in the variable is
// dead: it has no effect on the behaviour. Then the value false is stored instead. Equivalent states are thus equal,
// and if an input is chosen when it is read (ir/network_inputs.hpp), it is not chosen for a dead value.
#pragma once

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Changes the procedure `evolve` of the controller such that it stores false instead of dead values. Only variables
/// that no other process, no property and not Network::settled reads are changed. Requires that `network` is expanded.
/// If `ignore_readings` is true, all previous values count as dead, so that tests can show that the premise is necessary.
void clear_dead_values(Network& network, Id<Network::Controller> controller, bool ignore_readings = false);

}  // namespace grafverif
