// SPDX-License-Identifier: MIT
// main: the free inputs and timer ends, and the instances of the controllers' modules wired to them.
#include "grafverif/schedule/controller.hpp"

#include "schedule/constraints.hpp"
#include "schedule/controller_instances.hpp"
#include "schedule/observers.hpp"
#include "schedule/scope.hpp"

namespace grafverif {

namespace {

using namespace schedule;
using Role = Equations::Role;

/// The free variables that are each controller's own: ends of timers and its turn; wired as its last arguments.
void add_own_variables(Assembly& assembly, std::span<const ControllerPart> controllers) {
    const bool several = controllers.size() > 1;
    for (std::size_t index = 0; index < controllers.size(); ++index) {
        const Equations& equations = controllers[index].equations;
        const std::string prefix = several ? equations.name + "_" : "";
        for (const Id<Equations::Variable> id : assembly.modules[index].parameters) {
            const Equations::Variable& variable = equations.variables[id];
            if (variable.role != Role::TimerEnd) continue;
            const Id<Symbol> end =
                assembly.free(prefix + variable.name, variable.type, "ends of timers", variable.origin);
            assembly.system.instances[controller_instance(index)].arguments.push_back(end);
        }
    }
    for (std::size_t index = 0; several && index < controllers.size(); ++index) {
        const Equations& equations = controllers[index].equations;
        const Id<Symbol> turn = assembly.free("turn_" + equations.name, {}, "turns", equations.origin);
        assembly.system.instances[controller_instance(index)].arguments.push_back(turn);
    }
}

/// Instances get names that no free variable has; every controller that has a turn gets it again and again.
void name_instances(Assembly& assembly, std::span<const ControllerPart> controllers) {
    for (std::size_t index = 0; index < controllers.size(); ++index) {
        TransitionSystem::Instance& instance = assembly.system.instances[controller_instance(index)];
        instance.name = assembly.names.fresh(instance.name);
        if (controllers.size() == 1) continue;
        const Id<Expr> turn = assembly.system.exprs.leaf(Op::Variable, instance.arguments.back().index);
        assembly.main().justice.push_back(turn);
    }
}

/// Per shared variable its symbol in main, the free inputs among them added.
std::vector<Id<Symbol>> add_shared_inputs(Assembly& assembly, const ClosedLoop& loop) {
    std::vector<Id<Symbol>> symbols(loop.shared.size());
    for (const Id<ClosedLoop::Shared> id : loop.shared.ids()) {
        const ClosedLoop::Shared& shared = loop.shared[id];
        if (shared.reader.valid() && !shared.writer.valid())
            symbols[id.index] = assembly.free(shared.name, shared.type, "inputs", shared.origin);
    }
    return symbols;
}

/// The turn of each of several controllers, which is its last argument.
std::vector<Id<Expr>> turns(const TransitionSystem& system, Exprs& exprs, std::size_t controllers) {
    std::vector<Id<Expr>> found;
    for (std::size_t index = 0; controllers > 1 && index < controllers; ++index)
        found.push_back(
            exprs.leaf(Op::Variable, system.instances[controller_instance(index)].arguments.back().index));
    return found;
}

}  // namespace

TransitionSystem schedule_controller(const Equations& equations, ExecutionMode mode) {
    const std::vector<ControllerPart> controllers{{equations, mode}};
    Assembly assembly = assemble(controllers, false, false);
    assembly.system.scope = controllers_scope(controllers, false);
    assembly.system.name = equations.name;
    for (const Id<Equations::Variable> id : assembly.modules[0].parameters) {
        const Equations::Variable& variable = equations.variables[id];
        if (variable.role != Role::Input) continue;
        const Id<Symbol> input = assembly.free(variable.name, variable.type, "inputs", variable.origin);
        assembly.system.instances[controller_instance(0)].arguments.push_back(input);
    }
    add_own_variables(assembly, controllers);
    name_instances(assembly, controllers);
    Members all{assembly.system, assembly.modules, {}};
    assembly.system.settled = settled_controllers(all);
    add_fault_properties(all, std::span(&equations, 1));
    add_names(all, controllers, {});
    return std::move(assembly.system);
}

TransitionSystem schedule_controllers(const Model& model, const ClosedLoop& loop, std::span<const Equations> equations,
                                      const ScheduleOptions& options) {
    std::vector<ControllerPart> controllers;
    for (const Id<ClosedLoop::Controller> id : loop.controllers.ids())
        controllers.push_back({equations[id.index], options.mode.value_or(loop.controllers[id].mode)});
    Assembly assembly = assemble(controllers, controllers.size() > 1, false);
    TransitionSystem& system = assembly.system;
    const bool constrained = options.plant == PlantApproach::Constraints;
    system.name = loop.name;
    system.scope = controllers_scope(controllers, constrained);
    std::vector<Id<Symbol>> shared = add_shared_inputs(assembly, loop);
    add_own_variables(assembly, controllers);
    name_instances(assembly, controllers);
    Members all{system, assembly.modules, {}};
    share_outputs(all, loop, equations, shared);
    wire_inputs(all, loop, equations, shared);
    system.settled = settled_controllers(all);
    LoopMeaning meaning = meaning_of_controllers(all, model, loop, equations, shared);
    if (constrained) assume_constraints(system, loop, meaning);
    add_observers(all, loop, meaning, assembly.names, assembly.module_names);
    add_properties(system, loop, meaning);
    add_fault_properties(all, equations);
    add_names(all, controllers, turns(system, system.exprs, controllers.size()));
    return std::move(assembly.system);
}

}  // namespace grafverif
