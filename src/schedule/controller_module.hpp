// SPDX-License-Identifier: MIT
// One controller as a module of the TransitionSystem: its equations as init, next and definitions (DESDES06 6.1).
#pragma once

#include <vector>

#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/transition_system.hpp"
#include "schedule/main.hpp"

namespace grafverif::schedule {

struct ControllerModule {
    TransitionSystem::Module module = {};
    /// The inputs and timer outputs that are parameters, in order. `turn` and `elapse` follow if they are used.
    std::vector<Id<Equations::Variable>> parameters = {};
    /// The symbol of each variable of the equations that properties read. For an output, it is the value written to the
    /// plant.
    std::vector<Id<Symbol>> symbols = {};
    Id<Symbol> started = {};  ///< invalid if the first evolution has no visible effect and is not a separate step
    Id<Symbol> settled = {};
    Id<Symbol> race = {};                               ///< invalid if two stored actions can never race
    Id<Symbol> out_of_range = {};                       ///< invalid if no assignment can leave its range
    std::vector<Id<Equations::Variable>> bounded = {};  ///< variables whose assignments may leave their range
    Id<Symbol> faulting = {};  ///< for scans: the current step sets one of these flags; invalid if none is ever set
};

struct ControllerStyle {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    bool turns = false;  ///< true: the module has a parameter `turn`, and no variable changes while it is false
    /// If true, inputs come from a plant, and timer outputs are variables of the module. They are false when their step
    /// is activated, and may be set in any step with the parameter `elapse`, which only a module with timers has.
    /// Otherwise timer outputs are parameters.
    bool with_plant = false;
    /// If true, the module is used scan by scan: the first evolution is always a separate step, and the values that
    /// timers observe are variables.
    bool scans = false;
};
ControllerModule controller_module(const Equations& equations, const ControllerStyle& style, Exprs& exprs);

}  // namespace grafverif::schedule
