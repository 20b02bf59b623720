// SPDX-License-Identifier: MIT
#include "schedule/controller_instances.hpp"

#include "ir/shared_by_name.hpp"
#include "ir/words_of.hpp"
#include "schedule/properties.hpp"

namespace grafverif::schedule {

namespace {

using Role = Equations::Role;

/// Returns the names of controller `index` for traces: a map from its symbols to the names of its chart. `runs` is true
/// in steps in which the controller executes a cycle; if `runs` is invalid, the controller executes a cycle in every
/// step.
TransitionSystem::Controller words(const ControllerInstances& controllers, std::size_t index, Id<Expr> runs) {
    const Equations& equations = controllers.parts[index].equations;
    const ControllerModule& module = controllers.modules[index];
    std::vector<Id<Symbol>> argument_of(equations.variables.size());
    for (std::size_t i = 0; i < module.parameters.size(); ++i)
        argument_of[module.parameters[i].index] = controllers.arguments(index)[i];
    const auto in_main = [&](Id<Equations::Variable> id) {
        return argument_of[id.index].valid() ? argument_of[id.index] : controllers.variable(index, id);
    };
    TransitionSystem::Controller made{.words = words_of<Symbol>(equations, controllers.parts[index].mode, in_main)};
    made.evolves = runs;
    if (!module.started.valid()) return made;
    Exprs& exprs = controllers.main.system.exprs;
    const Id<Expr> started = controllers.inner(index, module.started);
    made.starts = exprs.negation(started);
    made.evolves = started;
    if (!runs.valid()) return made;
    made.starts = exprs.conjunction(runs, made.starts);
    made.evolves = exprs.conjunction(runs, started);
    return made;
}

}  // namespace

std::vector<ControllerPart> controller_parts(const ClosedLoop& loop, std::span<const Equations> equations,
                                             std::optional<ExecutionMode> mode) {
    std::vector<ControllerPart> found;
    for (const Id<ClosedLoop::Controller> id : loop.controllers.ids())
        found.push_back({equations[id.index], mode.value_or(loop.controllers[id].mode)});
    return found;
}

ControllerInstances::ControllerInstances(Main& in, std::vector<ControllerPart> of, bool turns, bool with_plant)
    : main(in), parts(std::move(of)) {
    for (const ControllerPart& part : parts) {
        ControllerModule module = controller_module(part.equations, {part.mode, turns, with_plant}, main.system.exprs);
        const Id<TransitionSystem::Module> id = main.add_module(std::move(module.module));
        instances.push_back(main.system.instances.add({part.equations.name, id, {}}));
        modules.push_back(std::move(module));
    }
}

Id<Symbol> ControllerInstances::variable(std::size_t controller, Id<Equations::Variable> id) const {
    const ControllerModule& module = modules[controller];
    if (const Id<Symbol> own = module.symbols[id.index]; own.valid()) return main.member(instances[controller], own);
    const auto given = std::ranges::find(module.parameters, id);
    return arguments(controller)[static_cast<std::size_t>(given - module.parameters.begin())];
}

void ControllerInstances::name() const {
    for (const Id<TransitionSystem::Instance> id : instances) {
        std::string& name = main.system.instances[id].name;
        name = main.draft.names.fresh(name);
    }
}

void ControllerInstances::share_outputs(const ClosedLoop& loop, std::vector<Id<Symbol>>& shared) const {
    const SharedByName place(loop);
    for (std::size_t index = 0; index < parts.size(); ++index) {
        const Table<Equations::Variable>& variables = parts[index].equations.variables;
        for (const Id<Equations::Variable> id : variables.ids())
            if (variables[id].role == Role::Output) shared[place(variables[id].name).index] = variable(index, id);
    }
}

void ControllerInstances::wire_inputs(const ClosedLoop& loop, const std::vector<Id<Symbol>>& shared) const {
    const SharedByName place(loop);
    for (std::size_t index = 0; index < parts.size(); ++index) {
        const Table<Equations::Variable>& variables = parts[index].equations.variables;
        std::vector<Id<Symbol>> inputs;
        for (const Id<Equations::Variable> id : modules[index].parameters)
            if (variables[id].role == Role::Input) inputs.push_back(shared[place(variables[id].name).index]);
        arguments(index).insert(arguments(index).begin(), inputs.begin(), inputs.end());
    }
}

Id<Expr> ControllerInstances::settled() const {
    std::vector<Id<Expr>> settled;
    for (std::size_t index = 0; index < parts.size(); ++index) settled.push_back(inner(index, modules[index].settled));
    return main.system.exprs.conjunction(settled);
}

void ControllerInstances::add_fault_properties() const {
    std::vector<Id<Expr>> races, ranges;
    std::string bounded;
    for (std::size_t index = 0; index < parts.size(); ++index) {
        const ControllerModule& module = modules[index];
        if (module.race.valid()) races.push_back(inner(index, module.race));
        if (module.out_of_range.valid()) ranges.push_back(inner(index, module.out_of_range));
        for (const Id<Equations::Variable> id : module.bounded)
            bounded += (bounded.empty() ? "" : ", ") + parts[index].equations.variables[id].name;
    }
    add_never(main.system, "no_race", "no two stored actions write different values to one variable in one cycle",
              races);
    const std::string text =
        bounded.empty() ? "nothing is divided by zero" : "no assignment leaves the range of its variable: " + bounded;
    add_never(main.system, "no_out_of_range", text, ranges);
}

void ControllerInstances::add_words(const std::vector<Id<Expr>>& runs) const {
    for (std::size_t index = 0; index < parts.size(); ++index)
        main.system.controllers.push_back(words(*this, index, runs.empty() ? Id<Expr>{} : runs[index]));
}

}  // namespace grafverif::schedule
