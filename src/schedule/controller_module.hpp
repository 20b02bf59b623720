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
    /// The inputs and timer outputs that are parameters of the module, in order. The parameters `turn` and `elapse`
    /// follow the inputs and timer outputs, if the module has these parameters.
    std::vector<Id<Equations::Variable>> parameters = {};
    /// For each variable of the equations: the symbol that properties read. For an output, this symbol represents the
    /// value written to the plant.
    std::vector<Id<Symbol>> symbols = {};
    /// False in the step of the first evolution; invalid if the first evolution has no visible effect and is not a
    /// separate step.
    Id<Symbol> started = {};
    Id<Symbol> settled = {};
    Id<Symbol> race = {};  ///< flag that remains set after a race of stored actions; invalid if no race is possible
    /// Flag that remains set after a fault; invalid if no assigned value can be outside the range of its variable and
    /// no term can divide by zero.
    Id<Symbol> out_of_range = {};
    /// Variables to which a value outside their range may be assigned.
    std::vector<Id<Equations::Variable>> bounded = {};
    /// With ControllerStyle::scans: true if the current step sets `race` or `out_of_range`; invalid if no step can set
    /// them.
    Id<Symbol> faulting = {};
};

struct ControllerStyle {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    /// True: the module has a parameter `turn`, and no variable changes in a step in which `turn` is false.
    bool turns = false;
    /// If true, inputs come from a plant, and timer outputs are variables of the module. A timer output is false when
    /// its step is activated, and may become true in any step in which the parameter `elapse` is true. Only a module
    /// with timers has the parameter `elapse`. If `with_plant` is false, timer outputs are parameters.
    bool with_plant = false;
    /// If true, the module belongs to a product (product.hpp): the first evolution is always a separate step, and the
    /// values that timers observe are variables.
    bool scans = false;
};
ControllerModule controller_module(const Equations& equations, const ControllerStyle& style, Exprs& exprs);

}  // namespace grafverif::schedule
