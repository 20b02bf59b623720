// SPDX-License-Identifier: MIT
// main: the free inputs and timer ends, and the instances of the controllers' modules wired to them.
#include "schedule/controller.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "bdd/terms.hpp"
#include "support/messages.hpp"
#include "schedule/controller_instances.hpp"
#include "schedule/observers.hpp"
#include "schedule/scope.hpp"

namespace grafverif {

namespace {

using namespace schedule;
using Role = Equations::Role;

// -- constraints as invariants over free inputs --

/// The inputs that a constraint reads; nothing where it reads something else.
std::optional<std::vector<Id<ClosedLoop::Shared>>> inputs_of(const ClosedLoop& loop, Id<Expr> condition) {
    std::vector<Id<ClosedLoop::Shared>> found;
    for (const Id<Expr> leaf : leaves(loop.exprs, condition)) {
        const Id<ClosedLoop::Symbol> symbol{static_cast<std::uint32_t>(loop.exprs[leaf].value)};
        const auto* shared = std::get_if<ClosedLoop::SharedSymbol>(&loop.symbols[symbol]);
        if (shared == nullptr) return {};
        const ClosedLoop::Shared& of = loop.shared[shared->shared];
        if (!of.reader.valid() || of.writer.valid()) return {};
        found.push_back(shared->shared);
    }
    return found;
}

/// The inputs that the constraints taken so far leave, as a function of their bits.
class Inputs {
public:
    /// Bits of one place are neighbours, so that inputs can be compared.
    explicit Inputs(const ClosedLoop& loop) : loop_(loop), terms_(loop.exprs, [this](const Expr& leaf) { return term(leaf); }) {
        std::size_t most = 0;
        for (const ClosedLoop::Constraint& constraint : loop.constraints)
            for (const Id<ClosedLoop::Shared> input : inputs_of(loop, constraint.condition).value_or(std::vector<Id<ClosedLoop::Shared>>{})) {
                const Type type = loop.shared[input].type;
                if (words_.try_emplace(input, BddWord{type, {}}).second) most = std::max(most, bit_count(type));
            }
        for (std::size_t place = most; place-- > 0;)
            for (auto& [input, word] : words_)
                if (place < bit_count(word.type)) word.bits.insert(word.bits.begin(), space_.add_variables(1));
        for (const auto& [input, word] : words_) left_ &= in_range(space_, word);
    }

    /// Whether the constraints so far and this one hold together of some inputs; nothing: that takes too much memory.
    std::optional<bool> admit(Id<Expr> condition) {
        try {
            const BddTerm& found = terms_(condition);
            left_ &= found.bits.front() & ~found.undefined;
            return !left_.is_false();
        } catch (const BddExhausted&) {
            return {};
        }
    }

private:
    BddTerm term(const Expr& leaf) const {
        const Id<ClosedLoop::Symbol> symbol{static_cast<std::uint32_t>(leaf.value)};
        return term_of(space_, words_.at(std::get<ClosedLoop::SharedSymbol>(loop_.symbols[symbol]).shared));
    }

    const ClosedLoop& loop_;
    BddSpace space_ = BddSpace({std::uint64_t{1} << 28U});
    std::map<Id<ClosedLoop::Shared>, BddWord> words_ = {};
    Bdd left_ = Bdd::constant(true);
    BddTerms terms_;
};

/// Every constraint that reads inputs of controllers only holds in every state (DESDES06 5.1); others say nothing of
/// this model.
void assume_constraints(const LoopMeaning& meaning) {
    TransitionSystem& system = meaning.system;
    for (const ClosedLoop::Constraint& constraint : meaning.loop.constraints) {
        std::string reason;
        if (!inputs_of(meaning.loop, constraint.condition)) continue;
        const Id<Expr> term = term_of(meaning, constraint.condition, reason);
        if (term.valid()) system.modules[system.main].invariants.push_back(term);
    }
}

// -- main --

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

bool constraints_agree(const ClosedLoop& loop, Diagnostics& diagnostics) {
    Inputs inputs(loop);
    for (const ClosedLoop::Constraint& constraint : loop.constraints) {
        if (!inputs_of(loop, constraint.condition)) continue;
        const std::optional<bool> admitted = inputs.admit(constraint.condition);
        if (admitted.value_or(false)) continue;
        diagnostics.add(messages::constraints_contradict(constraint.origin, constraint.name, admitted.has_value()));
        return false;
    }
    return true;
}

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
    LoopMeaning meaning{system, model, loop, equations, std::move(shared), of_controllers(all)};
    if (constrained) assume_constraints(meaning);
    add_observers(all, meaning, assembly.names, assembly.module_names);
    for (const Property& property : loop.properties) add_property(meaning, property);
    add_fault_properties(all, equations);
    add_names(all, controllers, turns(system, system.exprs, controllers.size()));
    return std::move(assembly.system);
}

}  // namespace grafverif
