// SPDX-License-Identifier: MIT
// Builds the procedures of the PLC cycle: translates the equations of a controller to sequences of assignments.
#pragma once

#include <vector>

#include "compose/controller.hpp"

namespace grafverif {

struct Procedures {
    std::vector<Network::Assignment> fire = {}, evolve = {}, write = {};
    /// The assignments of write() that reset samples, for a cycle that does not call write().
    std::vector<Network::Assignment> forget = {};
    std::vector<Network::Assignment> sample = {};  ///< samples of inputs that are held for all evolutions of a scan
    std::vector<Network::Assignment> start = {};   ///< executed before the first cycle if ControllerParts::starts holds
};

/// True if the mode is every_cycle or the first evolution has an effect.
bool starts(const Equations& equations, ExecutionMode mode);

Procedures procedures(Composition& composition, const ControllerParts& parts);

}  // namespace grafverif
