// SPDX-License-Identifier: MIT
// Independent subsystems of an interleaved loop: those of its network (ir/network_subsystems.hpp), translated to main.
#pragma once

#include <vector>

#include "schedule/plant_instances.hpp"

namespace grafverif::schedule {

/// Translates a term of the network, over variables and At, to main.
Id<Expr> over_main(const PlantInstances& plant, Id<Expr> term);

/// Returns at least two parts, or none. `turns` contains, per process, the condition that is true in its steps.
/// Requires that main has all its members.
std::vector<TransitionSystem::Subsystem> interleaved_subsystems(const PlantInstances& plant,
                                                                const std::vector<Id<Expr>>& turns);

}  // namespace grafverif::schedule
