// SPDX-License-Identifier: MIT
#include "schedule/properties.hpp"

#include "ir/step_names.hpp"
#include "support/overloaded.hpp"
#include "support/unique_names.hpp"
#include "syntax/print/sentence.hpp"
#include <algorithm>

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

namespace {

/// What a name of the loop stands for; or not valid, and `reason` says why.
Id<Expr> leaf_of(const LoopMeaning& meaning, const ClosedLoop::Symbol& symbol, std::string& reason) {
    const ClosedLoop& loop = meaning.loop;
    Exprs& exprs = meaning.system.exprs;
    const auto leaf = [&exprs](Id<Symbol> of) { return exprs.leaf(Op::Variable, of.index); };
    return std::visit(overloaded{
        [&](const ClosedLoop::SharedSymbol& of) -> Id<Expr> {
            if (meaning.shared[of.shared.index].valid()) return leaf(meaning.shared[of.shared.index]);
            reason = "`" + loop.shared[of.shared].name + "` is a variable of the plant";
            return {};
        },
        [&](const ClosedLoop::InternalSymbol& of) -> Id<Expr> {
            return leaf(meaning.variable(of.controller.index, {of.variable.index}));
        },
        [&](const ClosedLoop::StepSymbol& of) -> Id<Expr> {
            const Equations& chart = meaning.equations[of.controller.index];
            return leaf(meaning.variable(of.controller.index, chart.steps[of.step.index].variable));
        },
        [&](const ClosedLoop::LocationSymbol& of) -> Id<Expr> {
            if (meaning.at) return meaning.at(of.instance.index, of.location.index);
            const ClosedLoop::Instance& instance = loop.instances[of.instance];
            const Component& component = meaning.model.components[instance.component];
            reason = "`" + instance.name + "." + component.locations[of.location].name + "` is a location of the plant";
            return {};
        },
        [&](const ClosedLoop::ObserverSymbol& of) -> Id<Expr> {
            reason = meaning.unobserved[of.observer.index];
            if (!reason.empty()) return {};
            const Id<Expr> location = leaf(meaning.observers[of.observer.index]);
            return exprs.apply(Op::Equal, location, exprs.integer(of.location.index));
        },
    }, symbol);
}

/// Why the model cannot answer a pattern; empty: it can.
std::string refusal(const LoopMeaning& meaning, Pattern pattern) {
    switch (pattern) {
    case Pattern::NoDeadlock:
        return meaning.can_move.valid() ? "" : "this model is total, and cannot say whether the closed loop is";
    case Pattern::NoTimelock: return meaning.can_wait.valid() ? "" : "there is no time in this model";
    case Pattern::RawUppaal:  return "it is a formula for UPPAAL";
    case Pattern::Always: case Pattern::Never: case Pattern::Reachable: case Pattern::Inevitable:
    case Pattern::LeadsTo: case Pattern::ReachableAllSteps: case Pattern::ExactlyOneOf:
    case Pattern::AlwaysPossible: case Pattern::RawCtl: case Pattern::RawLtl:
        return {};
    }
    unreachable();
}

/// One `reachable` per step, named `PROP.X7`; with several controllers `PROP.chart.X7`.
void add_all_steps(const LoopMeaning& meaning, const Property& property) {
    for (std::size_t controller = 0; controller < meaning.equations.size(); ++controller) {
        const Equations& equations = meaning.equations[controller];
        const std::string chart = meaning.equations.size() > 1 ? equations.name + "." : "";
        for (const Equations::StepActivity& step : equations.steps) {
            Property one = property;
            one.name = property.name + "." + step_variable_name(chart + step.step);
            one.pattern = Pattern::Reachable;
            const Id<Symbol> active = meaning.variable(controller, step.variable);
            one.operands = {meaning.system.exprs.leaf(Op::Variable, active.index)};
            meaning.system.properties.add(std::move(one));
        }
    }
}

}  // namespace

Id<Expr> term_of(const LoopMeaning& meaning, Id<Expr> expr, std::string& reason) {
    const ClosedLoop& loop = meaning.loop;
    const auto symbol_of = [&](const Expr& leaf) -> const ClosedLoop::Symbol& {
        return loop.symbols[{static_cast<std::uint32_t>(leaf.value)}];
    };
    for (const Id<Expr> leaf : leaves(loop.exprs, expr))
        if (!leaf_of(meaning, symbol_of(loop.exprs[leaf]), reason).valid()) return {};
    return translate(loop.exprs, expr, meaning.system.exprs,
                     [&](const Expr& leaf) { return leaf_of(meaning, symbol_of(leaf), reason); });
}

void add_property(const LoopMeaning& meaning, const Property& property) {
    TransitionSystem& system = meaning.system;
    std::string reason = refusal(meaning, property.pattern);
    Property translated = property;
    translated.operands.clear();
    for (std::size_t k = 0; reason.empty() && k < property.operands.size(); ++k)
        translated.operands.push_back(term_of(meaning, property.operands[k], reason));
    if (!reason.empty()) {
        translated.operands.clear();
        system.omitted.push_back({std::move(translated), std::move(reason), system.properties.size()});
        return;
    }
    if (meaning.judged_when_settled) translated.at_stable = true;
    if (property.pattern == Pattern::ReachableAllSteps) return add_all_steps(meaning, translated);
    if (property.pattern == Pattern::NoDeadlock || property.pattern == Pattern::NoTimelock) {
        // Where no edge is enabled, time alone goes on until one is; so `possible` is `in the end`.
        translated.pattern = Pattern::AlwaysPossible;
        translated.operands = {property.pattern == Pattern::NoDeadlock ? meaning.can_move : meaning.can_wait};
    }
    system.properties.add(std::move(translated));
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
