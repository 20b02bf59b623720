// SPDX-License-Identifier: MIT
// The parts of a loop whose processes take turns: those of its network (ir/network_parts.hpp), in the terms of main.
#pragma once

#include <vector>

#include "schedule/plant_instances.hpp"

namespace grafverif::schedule {

/// A term of the network, over variables and At, in the terms of main.
Id<Expr> over_main(const PlantInstances& plant, Id<Expr> term);

/// Two or more, or none. `turns`: per process, it moves in a step. Requires that main has all its members.
std::vector<TransitionSystem::Part> parts_that_take_turns(const PlantInstances& plant,
                                                          const std::vector<Id<Expr>>& turns);

}  // namespace grafverif::schedule
