// SPDX-License-Identifier: MIT
// The procedures of the PLC cycle: the equations of a controller as sequences of assignments.
#pragma once

#include <vector>

#include "compose/controller.hpp"

namespace grafverif {

struct Procedures {
    std::vector<Network::Assignment> fire = {}, evolve = {}, write = {};
    std::vector<Network::Assignment> forget = {};  ///< what write() resets, for a cycle that does not write
    std::vector<Network::Assignment> start = {};   ///< before the first cycle; only where ControllerParts::starts
};

/// Whether the first evolution has anything to do.
bool starts(const Equations& equations, ExecutionMode mode);

Procedures procedures(Composition& composition, const ControllerParts& parts);

}  // namespace grafverif
