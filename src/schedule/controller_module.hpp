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
    /// The inputs and timer ends that are the parameters, in order; then `turn` and `elapse`, where there are any.
    std::vector<Id<Equations::Variable>> parameters = {};
    /// Each variable of the equations as properties read it: outputs as written to the plant.
    std::vector<Id<Symbol>> symbols = {};
    Id<Symbol> started = {};  ///< not valid: the first evolution shows in nothing, and is no step
    Id<Symbol> settled = {};
    Id<Symbol> race = {};                               ///< not valid: no two stored actions can race
    Id<Symbol> out_of_range = {};                       ///< not valid: every assignment stays in its range
    std::vector<Id<Equations::Variable>> bounded = {};  ///< the variables whose assignments may leave their range
    Id<Symbol> faulting = {};  ///< of scans: the step at hand sets one of these flags; not valid: none ever does
};

struct ControllerStyle {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    bool turns = false;  ///< a parameter `turn`: where it is false, nothing happens
    /// Inputs come from a plant, and timer ends are variables of the module:
    /// false from the activation of their step on; they may become true in a step with the parameter `elapse`, which
    /// only a module with timers has. Else timer ends are parameters.
    bool with_plant = false;
    /// Who looks at the module sees scans: the first evolution is a step whether it shows or not, and the levels that timers
    /// watch are variables.
    bool scans = false;
};
ControllerModule controller_module(const Equations& equations, const ControllerStyle& style, Exprs& exprs);

}  // namespace grafverif::schedule
