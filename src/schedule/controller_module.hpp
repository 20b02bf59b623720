// SPDX-License-Identifier: MIT
// Translates one controller to a module of the TransitionSystem: its equations become initial values, next values and
// definitions (DESDES06 6.1).
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
    /// The symbol of each variable of the equations that properties read. For an output, the symbol represents the
    /// value written to the plant.
    std::vector<Id<Symbol>> symbols = {};
    Id<Symbol> started = {};  ///< invalid if the first evolution has no visible effect and is not a separate step
    Id<Symbol> settled = {};
    Id<Symbol> race = {};          ///< invalid if a race of stored actions is impossible
    Id<Symbol> out_of_range = {};  ///< invalid if no assignment can leave its range and no term can divide by zero
    /// Variables to which a value outside their range may be assigned.
    std::vector<Id<Equations::Variable>> bounded = {};
    /// For scans: the current step sets `race` or `out_of_range`; invalid if this is impossible.
    Id<Symbol> faulting = {};
};

struct ControllerStyle {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    bool turns = false;  ///< true: the module has a parameter `turn`, and no variable changes while it is false
    /// If true, inputs come from a plant, and timer outputs are variables of the module. A timer output is false when
    /// its step is activated, and may become true in any step in which the parameter `elapse` is true. Only a module
    /// with timers has this parameter. Otherwise timer outputs are parameters.
    bool with_plant = false;
    /// If true, the module is used scan by scan: the first evolution is always a separate step, and the values that
    /// timers observe are variables.
    bool scans = false;
};
ControllerModule controller_module(const Equations& equations, const ControllerStyle& style, Exprs& exprs);

}  // namespace grafverif::schedule
