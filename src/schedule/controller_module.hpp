// SPDX-License-Identifier: MIT
// One controller as a module of the TransitionSystem: its equations as init, next and definitions (DESDES06 6.1).
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/transition_system.hpp"

namespace grafverif::schedule {

using Symbol = TransitionSystem::Symbol;

struct ControllerModule {
    TransitionSystem::Module module = {};
    /// The inputs and timer ends that are the parameters, in order; a `turn` comes last, where there is one.
    std::vector<Id<Equations::Variable>> parameters = {};
    /// Each variable of the equations as properties read it: outputs as written to the plant.
    std::vector<Id<Symbol>> symbols = {};
    /// Per variable the symbol that holds what the first evolution reads of it, where that matters.
    std::vector<Id<Symbol>> first = {};
    Id<Symbol> settled = {};
    Id<Symbol> race = {};                       ///< not valid: no two stored actions can race
    Id<Symbol> out_of_range = {};               ///< not valid: every assignment stays in its range
    std::vector<Id<Equations::Variable>> bounded = {};   ///< the variables whose assignments may leave their range
};

/// `turns`: the module has a parameter `turn`; where it is false, nothing happens.
ControllerModule controller_module(const Equations& equations, ExecutionMode mode, bool turns, Exprs& exprs);

}  // namespace grafverif::schedule
