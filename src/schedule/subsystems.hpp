// SPDX-License-Identifier: MIT
// Translates the independent subsystems of a network (ir/network_subsystems.hpp) to main, for schedule interleaved.
#pragma once

#include <vector>

#include "schedule/plant_instances.hpp"

namespace grafverif::schedule {

/// Translates a term of the network, over variables and At, to main.
Id<Expr> over_main(const PlantInstances& plant, Id<Expr> term);

/// Returns at least two subsystems, or an empty result. For each process, `turns` contains the condition that is true
/// in its steps. Requires that all symbols of main are declared.
std::vector<TransitionSystem::Subsystem> interleaved_subsystems(const PlantInstances& plant,
                                                                const std::vector<Id<Expr>>& turns);

}  // namespace grafverif::schedule
