// SPDX-License-Identifier: MIT
// Names and roles of a chart's elements (ControllerWords) for models that are built from its equations.
#pragma once

#include <algorithm>

#include "grafverif/ir/controller_words.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif {

/// Returns the index in `equations.steps` of the step that a timer observes, or nullopt if the timer observes another
/// term.
inline std::optional<std::size_t> watched_step(const Equations& equations, const Equations::Timer& timer) {
    const auto step = std::ranges::find(equations.steps, timer.watched, &Equations::StepActivity::variable);
    if (step == equations.steps.end()) return {};
    return static_cast<std::size_t>(step - equations.steps.begin());
}

/// Returns the term that a timer observes, in the notation of conditions, if the term is a name such as `X2` or `a`;
/// otherwise an empty string.
inline std::string watched_name(const Equations& equations, const Equations::Timer& timer) {
    if (const auto step = watched_step(equations, timer)) return equations.steps[*step].step.variable();
    const auto watch = std::ranges::find(equations.watches, timer.watched, &Equations::ObservedTerm::variable);
    const Expr& term = equations.exprs[watch->value];
    return term.op == Op::Variable ? equations.variables[{static_cast<std::uint32_t>(term.value)}].name : "";
}

/// Returns the names and roles for a model with variables of the type `Variable`. `place` maps a variable of the
/// equations to the corresponding variable of the model.
template <class Variable, class Place>
ControllerWords<Variable> words_of(const Equations& equations, ExecutionMode mode, const Place& place) {
    ControllerWords<Variable> words{.name = equations.name, .mode = mode};
    for (const Equations::StepActivity& step : equations.steps)
        words.steps.push_back({step.step, place(step.variable)});
    for (const Equations::Firing& firing : equations.firings)
        words.transitions.push_back({firing.transition, place(firing.variable)});
    for (const Id<Equations::Variable> id : equations.variables.ids()) {
        const Equations::Variable& variable = equations.variables[id];
        if (variable.role == Equations::Role::Input) words.inputs.push_back({variable.name, place(id)});
        if (variable.role == Equations::Role::Output) words.outputs.push_back({variable.name, place(id)});
        // The equations of a program contain no equation for an internal variable on which nothing depends.
        const bool known =
            !equations.is_program ||
            std::ranges::find(equations.stored, id, &Equations::Stored::variable) != equations.stored.end();
        if (variable.role == Equations::Role::Internal && known) words.internals.push_back({variable.name, place(id)});
    }
    for (const Equations::Timer& timer : equations.timers)
        words.timers.push_back({place(timer.end), watched_step(equations, timer), timer.rise_ms, timer.fall_ms,
                                watched_name(equations, timer)});
    for (const Id<Equations::Timer> timer : equations.conditions)
        words.conditions.push_back(timer.valid() ? std::optional<std::size_t>(timer.index) : std::nullopt);
    return words;
}

}  // namespace grafverif
