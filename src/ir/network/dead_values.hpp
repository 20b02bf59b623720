// SPDX-License-Identifier: MIT
// Dead values: previous values of terms (Role::Previous) that a PLC overwrites before anything reads them.
//
// For example, `XP0 && START && !START_previous` reads START_previous only if step P0 is active. The PLC overwrites the
// variable in each cycle. If P0 is not active after a cycle, the value that this cycle stores in the variable is dead:
// it has no effect on the behaviour. Therefore the value false is stored instead. As a result, states that differ only
// in dead values become identical. If an input is chosen when it is read (ir/network_inputs.hpp), no input is chosen
// for a dead value.
#pragma once

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Changes the procedure `evolve` of the controller such that it stores false instead of dead values. Changes only
/// variables that neither another process nor a property nor Network::settled reads. Requires that `network` is
/// expanded. If `ignore_readings` is true, all previous values count as dead, so that tests can show that the analysis
/// is necessary.
void clear_dead_values(Network& network, Id<Network::Controller> controller, bool ignore_readings = false);

}  // namespace grafverif
