// SPDX-License-Identifier: MIT
// Translates the independent subsystems of a network (ir/network_subsystems.hpp) to subsystems of a transition system
// with the schedule interleaved.
#pragma once

#include <vector>

#include "schedule/plant_instances.hpp"

namespace grafverif::schedule {

/// Translates a term of the network, over variables and At, to a term over symbols of main.
Id<Expr> over_main(const PlantInstances& plant, Id<Expr> term);

/// Returns the subsystems; the result is empty if there is only one subsystem. For each process, `turns` contains a
/// condition that is true in the steps in which the process moves. Requires that all symbols of main are declared.
std::vector<TransitionSystem::Subsystem> interleaved_subsystems(const PlantInstances& plant,
                                                                const std::vector<Id<Expr>>& turns);

}  // namespace grafverif::schedule
