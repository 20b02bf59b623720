// SPDX-License-Identifier: MIT
// main: the free inputs and timer ends, and the instances of the controllers' modules wired to them.
#include "grafverif/schedule/controller.hpp"

#include <algorithm>
#include <cassert>
#include <string_view>
#include <unordered_map>

#include "grafverif/support/overloaded.hpp"
#include "schedule/controller_module.hpp"
#include "schedule/properties.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

namespace {

using namespace schedule;
using Role = Equations::Role;

struct Controller {
    const Equations& equations;
    ExecutionMode mode = ExecutionMode::StabilitySearch;
};

std::string scope(std::span<const Controller> controllers) {
    const bool several = controllers.size() > 1;
    const std::string one = several ? "the controllers" : "the controller";
    std::string text = "This model is " + one +
                       " alone: in every cycle the inputs and the ends of timers take any value. " +
                       (several ? "In one step each controller whose turn it is runs one PLC cycle; each has its turn "
                                  "infinitely often. "
                                : "One step is one PLC cycle. ") +
                       "State 0 is the state after the first evolution. ";
    for (const Controller& controller : controllers) {
        text += several ? "The outputs of " + controller.equations.name : "Outputs";
        text += controller.mode == ExecutionMode::StabilitySearch ? " are written when the situation is stable. "
                                                                  : " are written in every cycle. ";
    }
    return text +
           "An always, never, exactly one of or inevitable that holds here, and a leads to that holds and whose left "
           "side reads no input, holds with every plant in grain atomic, from the first evolution on, provided that "
           "the plant lets " +
           one +
           " run; so does a reachable that is violated here. What fails here may yet hold "
           "with the real plant. All other verdicts are about this model only: reachable that holds, always "
           "possible, CTL and LTL formulas, and, at stable, all but always, never and exactly one of.";
}

/// The modules and main, without properties. `names`: those taken in main.
struct Assembly {
    TransitionSystem system = {};
    std::vector<ControllerModule> modules = {};
    UniqueNames names = {};

    TransitionSystem::Module& main() { return system.modules[system.main]; }

    Id<Symbol> free(const std::string& wish, Type type, const char* section, Span origin) {
        return main().symbols.add({names.fresh(wish), type, TransitionSystem::StateSymbol{}, section, origin});
    }
};

Assembly assemble(std::span<const Controller> controllers) {
    Assembly assembly;
    assembly.system.scope = scope(controllers);
    assembly.system.main = assembly.system.modules.add({"main", {}, {}, {}});
    UniqueNames module_names;
    module_names.fresh("main");
    for (const Controller& controller : controllers) {
        ControllerModule module = controller_module(controller.equations, controller.mode, controllers.size() > 1,
                                                    assembly.system.exprs);
        module.module.name = module_names.fresh(module.module.name);
        const Id<TransitionSystem::Module> id = assembly.system.modules.add(std::move(module.module));
        assembly.system.instances.add({controller.equations.name, id, {}});
        assembly.modules.push_back(std::move(module));
    }
    return assembly;
}

Id<TransitionSystem::Instance> instance_id(std::size_t controller) { return {static_cast<std::uint32_t>(controller)}; }

/// The free variables that are each controller's own: ends of timers and its turn; wired as its last arguments.
void add_own_variables(Assembly& assembly, std::span<const Controller> controllers) {
    const bool several = controllers.size() > 1;
    for (std::size_t index = 0; index < controllers.size(); ++index) {
        const Equations& equations = controllers[index].equations;
        const std::string prefix = several ? equations.name + "_" : "";
        for (const Id<Equations::Variable> id : assembly.modules[index].parameters) {
            const Equations::Variable& variable = equations.variables[id];
            if (variable.role != Role::TimerEnd) continue;
            const Id<Symbol> end =
                assembly.free(prefix + variable.name, variable.type, "ends of timers", variable.origin);
            assembly.system.instances[instance_id(index)].arguments.push_back(end);
        }
    }
    for (std::size_t index = 0; several && index < controllers.size(); ++index) {
        const Equations& equations = controllers[index].equations;
        const Id<Symbol> turn = assembly.free("turn_" + equations.name, {}, "turns", equations.origin);
        assembly.system.instances[instance_id(index)].arguments.push_back(turn);
    }
}

/// Instances get names that no free variable has; every controller that has a turn gets it again and again.
void name_instances(Assembly& assembly, std::span<const Controller> controllers) {
    for (std::size_t index = 0; index < controllers.size(); ++index) {
        TransitionSystem::Instance& instance = assembly.system.instances[instance_id(index)];
        instance.name = assembly.names.fresh(instance.name);
        if (controllers.size() == 1) continue;
        const Id<Expr> turn = assembly.system.exprs.leaf(Op::Variable, instance.arguments.back().index);
        assembly.main().justice.push_back(turn);
    }
}

void add_settled(Members& members) {
    std::vector<Id<Expr>> settled;
    for (std::size_t index = 0; index < members.controllers.size(); ++index) {
        const Id<Symbol> symbol = member(members, index, members.controllers[index].settled);
        settled.push_back(members.system.exprs.leaf(Op::Variable, symbol.index));
    }
    members.system.settled = members.system.exprs.conjunction(settled);
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

/// Outputs as shared variables, and the inputs of every instance before its timer ends. A shared variable has the name
/// of the input or output that it is, in every chart that reads or writes it.
void wire(Members& members, const ClosedLoop& loop, std::span<const Equations> equations,
          std::vector<Id<Symbol>>& shared) {
    std::unordered_map<std::string_view, Id<ClosedLoop::Shared>> by_name;
    for (const Id<ClosedLoop::Shared> id : loop.shared.ids()) by_name.emplace(loop.shared[id].name, id);
    const auto known = [&](const Equations::Variable& variable) {
        const auto found = by_name.find(variable.name);
        assert(found != by_name.end());
        return found->second;
    };
    for (std::size_t index = 0; index < equations.size(); ++index)
        for (const Id<Equations::Variable> id : equations[index].variables.ids())
            if (equations[index].variables[id].role == Role::Output)
                shared[known(equations[index].variables[id]).index] =
                    member(members, index, members.controllers[index].symbols[id.index]);
    for (std::size_t index = 0; index < equations.size(); ++index) {
        std::vector<Id<Symbol>> inputs;
        for (const Id<Equations::Variable> id : members.controllers[index].parameters)
            if (equations[index].variables[id].role == Role::Input)
                inputs.push_back(shared[known(equations[index].variables[id]).index]);
        std::vector<Id<Symbol>>& arguments = members.system.instances[instance_id(index)].arguments;
        arguments.insert(arguments.begin(), inputs.begin(), inputs.end());
    }
}

/// What traces say of controller `index`: its symbols under the names of its chart.
TransitionSystem::Controller named_controller(Members& members, std::size_t index, const Controller& controller) {
    const Equations& equations = controller.equations;
    const ControllerModule& module = members.controllers[index];
    TransitionSystem::Controller named{.name = equations.name, .mode = controller.mode};
    const auto in_main = [&](Id<Equations::Variable> id) { return member(members, index, module.symbols[id.index]); };
    for (const Equations::StepActivity& step : equations.steps)
        named.steps.push_back({step.step, in_main(step.variable)});
    for (const Equations::Firing& firing : equations.firings)
        named.transitions.push_back({firing.transition, in_main(firing.variable)});
    const std::vector<Id<Symbol>>& arguments = members.system.instances[instance_id(index)].arguments;
    std::vector<Id<Symbol>> argument_of(equations.variables.size());
    for (std::size_t i = 0; i < module.parameters.size(); ++i) argument_of[module.parameters[i].index] = arguments[i];
    for (const Id<Equations::Variable> id : equations.variables.ids()) {
        const Equations::Variable& variable = equations.variables[id];
        if (variable.role == Role::Input) {
            const Id<Symbol> first = module.first[id.index];
            named.inputs.push_back({variable.name, argument_of[id.index],
                                    first.valid() ? member(members, index, first) : Id<Symbol>{}});
        }
        if (variable.role == Role::Output) named.outputs.push_back({variable.name, in_main(id)});
        if (variable.role == Role::Internal) named.internals.push_back({variable.name, in_main(id)});
    }
    for (const Equations::Timer& timer : equations.timers) {
        const auto step = std::ranges::find(equations.steps, timer.watched, &Equations::StepActivity::variable);
        std::optional<std::size_t> watched;
        if (step != equations.steps.end()) watched = static_cast<std::size_t>(step - equations.steps.begin());
        named.timers.push_back({argument_of[timer.end.index], watched, timer.rise_ms, timer.fall_ms});
    }
    for (const Id<Equations::Timer> timer : equations.conditions)
        named.conditions.push_back(timer.valid() ? std::optional<std::size_t>(timer.index) : std::nullopt);
    if (members.controllers.size() > 1)
        named.evolves = members.system.exprs.leaf(Op::Variable, arguments.back().index);
    return named;
}

void add_names(Members& members, std::span<const Controller> controllers) {
    for (std::size_t index = 0; index < controllers.size(); ++index)
        members.system.controllers.push_back(named_controller(members, index, controllers[index]));
}

}  // namespace

TransitionSystem schedule_controller(const Equations& equations, ExecutionMode mode) {
    const std::vector<Controller> controllers{{equations, mode}};
    Assembly assembly = assemble(controllers);
    assembly.system.name = equations.name;
    for (const Id<Equations::Variable> id : assembly.modules[0].parameters) {
        const Equations::Variable& variable = equations.variables[id];
        if (variable.role != Role::Input) continue;
        const Id<Symbol> input = assembly.free(variable.name, variable.type, "inputs", variable.origin);
        assembly.system.instances[instance_id(0)].arguments.push_back(input);
    }
    add_own_variables(assembly, controllers);
    name_instances(assembly, controllers);
    Members all = members(assembly.system, assembly.modules);
    add_settled(all);
    add_fault_properties(all, std::span(&equations, 1));
    add_names(all, controllers);
    return std::move(assembly.system);
}

TransitionSystem schedule_controllers(const Model& model, const ClosedLoop& loop, std::span<const Equations> equations,
                                      const ScheduleOptions& options) {
    std::vector<Controller> controllers;
    for (const Id<ClosedLoop::Controller> id : loop.controllers.ids())
        controllers.push_back({equations[id.index], options.mode.value_or(loop.controllers[id].mode)});
    Assembly assembly = assemble(controllers);
    assembly.system.name = loop.name;
    std::vector<Id<Symbol>> shared = add_shared_inputs(assembly, loop);
    add_own_variables(assembly, controllers);
    name_instances(assembly, controllers);
    Members all = members(assembly.system, assembly.modules);
    wire(all, loop, equations, shared);
    add_settled(all);
    add_properties(all, model, loop, equations, shared);
    add_fault_properties(all, equations);
    add_names(all, controllers);
    return std::move(assembly.system);
}

}  // namespace grafverif
