// SPDX-License-Identifier: MIT
// Builds the module `main`, which contains the free inputs and timer outputs, and the instances of the controllers'
// modules.
#include "schedule/controller.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "bdd/terms.hpp"
#include "schedule/controller_instances.hpp"
#include "schedule/observers.hpp"
#include "schedule/scope.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

using namespace schedule;
using Role = Equations::Role;

// -- constraints as invariants over free inputs --

/// Returns the inputs that a constraint reads, or nullopt if the constraint also reads other variables.
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

/// The set of input combinations that satisfy the constraints added so far, as a Boolean function of the input bits.
class Inputs {
public:
    /// In the variable order, bits of equal significance are adjacent, so that comparisons of inputs have small
    /// decision diagrams.
    explicit Inputs(const ClosedLoop& loop)
        : loop_(loop), terms_(loop.exprs, [this](const Expr& leaf) { return term(leaf); }) {
        std::size_t most = 0;
        for (const ClosedLoop::Constraint& constraint : loop.constraints)
            for (const Id<ClosedLoop::Shared> input :
                 inputs_of(loop, constraint.condition).value_or(std::vector<Id<ClosedLoop::Shared>>{})) {
                const Type type = loop.shared[input].type;
                if (words_.try_emplace(input, BddWord{type, {}}).second) most = std::max(most, bit_count(type));
            }
        for (std::size_t place = most; place-- > 0;)
            for (auto& [input, word] : words_)
                if (place < bit_count(word.type)) word.bits.insert(word.bits.begin(), space_.add_variables(1));
        for (const auto& [input, word] : words_) left_ &= in_range(space_, word);
    }

    /// Adds a constraint. Returns true if all constraints added so far are jointly satisfiable, or nullopt if the
    /// memory limit is reached.
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

/// Adds every constraint that reads only inputs of controllers as an invariant (DESDES06 5.1). The model of controllers
/// without a plant ignores all other constraints.
void assume_constraints(const LoopMeaning& meaning) {
    for (const ClosedLoop::Constraint& constraint : meaning.loop.constraints) {
        std::string reason;
        if (!inputs_of(meaning.loop, constraint.condition)) continue;
        const Id<Expr> term = term_of(meaning, constraint.condition, reason);
        if (term.valid()) meaning.main.draft.module.invariants.push_back(term);
    }
}

// -- main --

Id<Symbol> add_free(Main& main, const std::string& preferred, Type type, const char* section, Span origin) {
    return main.draft.add(preferred, type, TransitionSystem::StateSymbol{}, section, origin);
}

/// Adds the free variables of each controller as its last arguments: its timer outputs and, if there are several
/// controllers, its `turn` variable. Then sets unique names of the instances. Returns the `turn` variables, each of
/// which is true infinitely often.
std::vector<Id<Expr>> add_own_variables(const ControllerInstances& controllers) {
    Main& main = controllers.main;
    const bool several = controllers.parts.size() > 1;
    for (std::size_t index = 0; index < controllers.parts.size(); ++index) {
        const Equations& equations = controllers.parts[index].equations;
        const std::string prefix = several ? equations.name + "_" : "";
        for (const Id<Equations::Variable> id : controllers.modules[index].parameters) {
            const auto& [name, role, type, initial, origin] = equations.variables[id];
            if (role == Role::TimerEnd)
                controllers.arguments(index).push_back(
                    add_free(main, prefix + name, type, "outputs of timers", origin));
        }
    }
    std::vector<Id<Expr>> turns;
    for (std::size_t index = 0; several && index < controllers.parts.size(); ++index) {
        const Equations& equations = controllers.parts[index].equations;
        const Id<Symbol> turn = add_free(main, "turn_" + equations.name, {}, "turns", equations.origin);
        controllers.arguments(index).push_back(turn);
        turns.push_back(main.draft.leaf(turn));
    }
    controllers.name();
    main.draft.module.justice = turns;
    return turns;
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
    Main main(equations.name);
    const ControllerInstances controllers(main, {{equations, mode}}, false, false);
    main.system.scope = controllers_scope(controllers.parts, false);
    for (const Id<Equations::Variable> id : controllers.modules[0].parameters) {
        const auto& [name, role, type, initial, origin] = equations.variables[id];
        if (role == Role::Input) controllers.arguments(0).push_back(add_free(main, name, type, "inputs", origin));
    }
    add_own_variables(controllers);
    main.system.settled = controllers.settled();
    controllers.add_fault_properties();
    controllers.add_words({});
    return main.finish();
}

TransitionSystem schedule_controllers(const Model& model, const ClosedLoop& loop, std::span<const Equations> equations,
                                      const ScheduleOptions& options) {
    const std::vector<ControllerPart> parts = controller_parts(loop, equations, options.mode);
    Main main(loop.name);
    const ControllerInstances controllers(main, parts, parts.size() > 1, false);
    const bool constrained = options.plant == PlantApproach::Constraints;
    main.system.scope = controllers_scope(parts, constrained);
    std::vector<Id<Symbol>> shared;
    for (const ClosedLoop::Shared& each : loop.shared) {
        const bool input = each.reader.valid() && !each.writer.valid();
        shared.push_back(input ? add_free(main, each.name, each.type, "inputs", each.origin) : Id<Symbol>{});
    }
    const std::vector<Id<Expr>> turns = add_own_variables(controllers);
    controllers.share_outputs(loop, shared);
    controllers.wire_inputs(loop, shared);
    main.system.settled = controllers.settled();
    LoopMeaning meaning{
        main, model, loop, equations, std::move(shared), [&](std::size_t controller, Id<Equations::Variable> id) {
            return controllers.variable(controller, id);
        }};
    if (constrained) assume_constraints(meaning);
    add_observers(meaning);
    for (const Property& property : loop.properties) add_property(meaning, property);
    controllers.add_fault_properties();
    controllers.add_words(turns);
    return main.finish();
}

}  // namespace grafverif
