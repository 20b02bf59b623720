// SPDX-License-Identifier: MIT
#include "compare/identical.hpp"

namespace grafverif {

namespace {

void clear_origins(auto& list) {
    for (auto& each : list) each.origin = {};
}

Equations without_names(Equations equations) {
    equations.name.clear();
    equations.origin = {};
    for (Equations::Variable& variable : equations.variables)
        if (variable.role != Equations::Role::Input && variable.role != Equations::Role::Output) variable.name.clear();
    for (Equations::Firing& firing : equations.firings) firing.transition.clear();
    for (Equations::StepActivity& step : equations.steps) step.step = {};
    for (Equations::Timer& timer : equations.timers) timer.name.clear();
    for (Equations::Stored& stored : equations.stored) clear_origins(stored.writes);
    clear_origins(equations.variables);
    clear_origins(equations.firings);
    clear_origins(equations.steps);
    clear_origins(equations.conflicts);
    clear_origins(equations.previous);
    clear_origins(equations.watches);
    clear_origins(equations.timers);
    clear_origins(equations.outputs);
    clear_origins(equations.assumptions);
    return equations;
}

}  // namespace

bool identical_up_to_names(const Equations& a, const Equations& b) { return without_names(a) == without_names(b); }

}  // namespace grafverif
