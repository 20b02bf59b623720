// SPDX-License-Identifier: MIT
#include "schedule/properties.hpp"

#include <algorithm>

#include "ir/step_names.hpp"
#include "support/overloaded.hpp"
#include "support/unique_names.hpp"
#include "syntax/print/sentence.hpp"

namespace grafverif::schedule {

Id<Symbol> member(Members& members, Id<TransitionSystem::Instance> instance, Id<Symbol> symbol) {
    const auto [known, fresh] = members.known.try_emplace({instance, symbol});
    if (!fresh) return known->second;
    TransitionSystem& system = members.system;
    const Symbol inner = system.modules[system.instances[instance].module].symbols[symbol];
    return known->second = system.modules[system.main].symbols.add(
               {system.instances[instance].name + "." + inner.name, inner.type,
                TransitionSystem::MemberSymbol{instance, symbol}, "", inner.origin, inner.values});
}

Id<Symbol> member(Members& members, std::size_t controller, Id<Symbol> symbol) {
    return member(members, Id<TransitionSystem::Instance>{static_cast<std::uint32_t>(controller)}, symbol);
}

std::string untimed_refusal(Pattern pattern) {
    switch (pattern) {
    case Pattern::NoDeadlock: return "this model is total, and cannot say whether the closed loop is";
    case Pattern::NoTimelock: return "there is no time in this model";
    case Pattern::RawUppaal:  return "it is a formula for UPPAAL";
    case Pattern::Always: case Pattern::Never: case Pattern::Reachable: case Pattern::Inevitable:
    case Pattern::LeadsTo: case Pattern::ReachableAllSteps: case Pattern::ExactlyOneOf:
    case Pattern::AlwaysPossible: case Pattern::RawCtl: case Pattern::RawLtl:
        return {};
    }
    unreachable();
}

LoopMeaning meaning_of_controllers(Members& members, const Model& model, const ClosedLoop& loop,
                                   std::span<const Equations> equations, const std::vector<Id<Symbol>>& shared) {
    const auto leaf = [&members](Id<Symbol> symbol) { return members.system.exprs.leaf(Op::Variable, symbol.index); };
    const auto of_controller = [&members, leaf](std::size_t controller, std::size_t variable) {
        return leaf(member(members, controller, members.controllers[controller].symbols[variable]));
    };
    LoopMeaning meaning;
    meaning.refusal = untimed_refusal;
    meaning.term = [&loop, &model, equations, shared, leaf, of_controller](const ClosedLoop::Symbol& symbol,
                                                                          std::string& reason) {
        return std::visit(overloaded{
            [&](const ClosedLoop::SharedSymbol& of) -> Id<Expr> {
                const Id<Symbol> known = shared[of.shared.index];
                if (known.valid()) return leaf(known);
                reason = "`" + loop.shared[of.shared].name + "` is a variable of the plant";
                return {};
            },
            [&](const ClosedLoop::InternalSymbol& of) -> Id<Expr> {
                return of_controller(of.controller.index, of.variable.index);
            },
            [&](const ClosedLoop::StepSymbol& of) -> Id<Expr> {
                const Equations& chart = equations[of.controller.index];
                return of_controller(of.controller.index, chart.steps[of.step.index].variable.index);
            },
            [&](const ClosedLoop::LocationSymbol& of) -> Id<Expr> {
                const ClosedLoop::Instance& instance = loop.instances[of.instance];
                const Component& component = model.components[instance.component];
                reason = "`" + instance.name + "." + component.locations[of.location].name +
                         "` is a location of the plant";
                return {};
            },
            [&](const ClosedLoop::ObserverSymbol& of) -> Id<Expr> {
                reason = "`" + loop.observers[of.observer].name + "` is an observer";
                return {};
            },
        }, symbol);
    };
    for (std::size_t controller = 0; controller < equations.size(); ++controller) {
        const std::string chart = equations.size() > 1 ? equations[controller].name + "." : "";
        for (const Equations::StepActivity& step : equations[controller].steps)
            meaning.steps.push_back({chart + step.step, of_controller(controller, step.variable.index)});
    }
    return meaning;
}

Id<Expr> term_of(TransitionSystem& system, const ClosedLoop& loop, const LoopMeaning& meaning, Id<Expr> expr,
                 std::string& reason) {
    const auto symbol_of = [&](const Expr& leaf) -> const ClosedLoop::Symbol& {
        return loop.symbols[{static_cast<std::uint32_t>(leaf.value)}];
    };
    for (const Id<Expr> leaf : leaves(loop.exprs, expr))
        if (!meaning.term(symbol_of(loop.exprs[leaf]), reason).valid()) return {};
    return translate(loop.exprs, expr, system.exprs, [&](const Expr& leaf) {
        std::string none;
        return meaning.term(symbol_of(leaf), none);
    });
}

namespace {

/// One `reachable` per step, named `PROP.X7`; with several controllers `PROP.chart.X7`.
void add_all_steps(TransitionSystem& system, const Property& property, const LoopMeaning& meaning) {
    for (const StepTerm& step : meaning.steps) {
        Property one = property;
        one.name = property.name + "." + step_variable_name(step.label);
        one.pattern = Pattern::Reachable;
        one.operands = {step.active};
        system.properties.add(std::move(one));
    }
}

void add_property(TransitionSystem& system, const ClosedLoop& loop, const LoopMeaning& meaning,
                  const Property& property) {
    std::string reason = meaning.refusal(property.pattern);
    Property translated = property;
    translated.operands.clear();
    for (std::size_t k = 0; reason.empty() && k < property.operands.size(); ++k)
        translated.operands.push_back(term_of(system, loop, meaning, property.operands[k], reason));
    if (!reason.empty()) {
        translated.operands.clear();
        system.omitted.push_back({std::move(translated), std::move(reason), system.properties.size()});
        return;
    }
    if (meaning.judged_when_settled) translated.at_stable = true;
    if (property.pattern == Pattern::ReachableAllSteps) add_all_steps(system, translated, meaning);
    else system.properties.add(std::move(translated));
}

}  // namespace

void add_properties(TransitionSystem& system, const ClosedLoop& loop, const LoopMeaning& meaning) {
    for (const Property& property : loop.properties) add_property(system, loop, meaning, property);
}

void add_constraint_properties(TransitionSystem& system, const ClosedLoop& loop, const LoopMeaning& meaning) {
    UniqueNames names;
    for (const Property& property : system.properties) names.fresh(property.name);
    for (const ClosedLoop::Constraint& constraint : loop.constraints) {
        std::string reason;
        const Id<Expr> term = term_of(system, loop, meaning, constraint.condition, reason);
        if (!term.valid()) continue;
        system.properties.add({.name = names.fresh(constraint.name),
                               .text = sentence(loop, constraint),
                               .pattern = Pattern::Always,
                               .operands = {term},
                               .at_stable = meaning.judged_when_settled,
                               .origin = constraint.origin});
    }
}

void add_never(TransitionSystem& system, std::string name, std::string text, const std::vector<Id<Expr>>& flags) {
    if (flags.empty()) return;
    Property property;
    property.name = std::move(name);
    property.text = std::move(text);
    property.pattern = Pattern::Never;
    property.operands = {system.exprs.disjunction(flags)};
    system.properties.add(std::move(property));
}

void add_fault_properties(Members& members, std::span<const Equations> equations) {
    std::vector<Id<Expr>> races, ranges;
    std::string bounded;
    const auto flag = [&](std::size_t controller, Id<Symbol> symbol) {
        return members.system.exprs.leaf(Op::Variable, member(members, controller, symbol).index);
    };
    for (std::size_t controller = 0; controller < equations.size(); ++controller) {
        const ControllerModule& module = members.controllers[controller];
        if (module.race.valid()) races.push_back(flag(controller, module.race));
        if (module.out_of_range.valid()) ranges.push_back(flag(controller, module.out_of_range));
        for (const Id<Equations::Variable> id : module.bounded)
            bounded += (bounded.empty() ? "" : ", ") + equations[controller].variables[id].name;
    }
    add_never(members.system, "no_race", "no two stored actions write different values to one variable in one cycle",
              races);
    const std::string text = bounded.empty() ? "nothing is divided by zero"
                                             : "no assignment leaves the range of its variable: " + bounded;
    add_never(members.system, "no_out_of_range", text, ranges);
}

}  // namespace grafverif::schedule
