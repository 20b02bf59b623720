// SPDX-License-Identifier: MIT
#include "schedule/controller_instances.hpp"

#include <cassert>
#include <string_view>
#include <unordered_map>

#include "ir/words_of.hpp"

namespace grafverif::schedule {

namespace {

using Role = Equations::Role;

/// The shared variables of a loop by name: those of the inputs and outputs that they are.
class SharedByName {
public:
    explicit SharedByName(const ClosedLoop& loop) {
        for (const Id<ClosedLoop::Shared> id : loop.shared.ids()) known_.emplace(loop.shared[id].name, id);
    }
    std::size_t operator()(const Equations::Variable& variable) const {
        const auto found = known_.find(variable.name);
        assert(found != known_.end());
        return found->second.index;
    }

private:
    std::unordered_map<std::string_view, Id<ClosedLoop::Shared>> known_ = {};
};

/// What traces say of controller `index`: its symbols under the names of its chart. `runs`: it makes a cycle; not valid:
/// in every step.
TransitionSystem::Controller named_controller(Members& members, std::size_t index, const ControllerPart& controller,
                                              Id<Expr> runs) {
    const Equations& equations = controller.equations;
    const ControllerModule& module = members.controllers[index];
    std::vector<Id<Symbol>> argument_of(equations.variables.size());
    const std::vector<Id<Symbol>>& arguments = members.system.instances[controller_instance(index)].arguments;
    for (std::size_t i = 0; i < module.parameters.size(); ++i) argument_of[module.parameters[i].index] = arguments[i];
    const auto in_main = [&](Id<Equations::Variable> id) {
        const Id<Symbol> argument = argument_of[id.index];
        return argument.valid() ? argument : member(members, index, module.symbols[id.index]);
    };
    TransitionSystem::Controller named{.words = words_of<Symbol>(equations, controller.mode, in_main)};
    named.evolves = runs;
    if (!module.started.valid()) return named;
    Exprs& exprs = members.system.exprs;
    const Id<Expr> started = exprs.leaf(Op::Variable, member(members, index, module.started).index);
    named.starts = exprs.negation(started);
    named.evolves = started;
    if (!runs.valid()) return named;
    named.starts = exprs.conjunction(runs, named.starts);
    named.evolves = exprs.conjunction(runs, started);
    return named;
}

}  // namespace

Assembly assemble(std::span<const ControllerPart> controllers, bool turns, bool with_plant) {
    Assembly assembly;
    assembly.system.main = assembly.system.modules.add({"main", {}, {}, {}, {}});
    assembly.module_names.fresh("main");
    for (const ControllerPart& controller : controllers) {
        ControllerModule module =
            controller_module(controller.equations, {controller.mode, turns, with_plant}, assembly.system.exprs);
        module.module.name = assembly.module_names.fresh(module.module.name);
        const Id<TransitionSystem::Module> id = assembly.system.modules.add(std::move(module.module));
        assembly.system.instances.add({controller.equations.name, id, {}});
        assembly.modules.push_back(std::move(module));
    }
    return assembly;
}

void share_outputs(Members& members, const ClosedLoop& loop, std::span<const Equations> equations,
                   std::vector<Id<Symbol>>& shared) {
    const SharedByName place(loop);
    for (std::size_t index = 0; index < equations.size(); ++index)
        for (const Id<Equations::Variable> id : equations[index].variables.ids())
            if (equations[index].variables[id].role == Role::Output)
                shared[place(equations[index].variables[id])] =
                    member(members, index, members.controllers[index].symbols[id.index]);
}

void wire_inputs(Members& members, const ClosedLoop& loop, std::span<const Equations> equations,
                 const std::vector<Id<Symbol>>& shared) {
    const SharedByName place(loop);
    for (std::size_t index = 0; index < equations.size(); ++index) {
        std::vector<Id<Symbol>> inputs;
        for (const Id<Equations::Variable> id : members.controllers[index].parameters)
            if (equations[index].variables[id].role == Role::Input)
                inputs.push_back(shared[place(equations[index].variables[id])]);
        std::vector<Id<Symbol>>& arguments = members.system.instances[controller_instance(index)].arguments;
        arguments.insert(arguments.begin(), inputs.begin(), inputs.end());
    }
}

Id<Expr> settled_controllers(Members& members) {
    std::vector<Id<Expr>> settled;
    for (std::size_t index = 0; index < members.controllers.size(); ++index) {
        const Id<Symbol> symbol = member(members, index, members.controllers[index].settled);
        settled.push_back(members.system.exprs.leaf(Op::Variable, symbol.index));
    }
    return members.system.exprs.conjunction(settled);
}

void add_names(Members& members, std::span<const ControllerPart> controllers, const std::vector<Id<Expr>>& runs) {
    for (std::size_t index = 0; index < controllers.size(); ++index)
        members.system.controllers.push_back(named_controller(
            members, index, controllers[index], runs.empty() ? Id<Expr>{} : runs[index]));
}

}  // namespace grafverif::schedule
