// SPDX-License-Identifier: MIT
#include "schedule/properties.hpp"

#include <algorithm>

#include "support/overloaded.hpp"

namespace grafverif::schedule {

namespace {

/// Translates a name of the loop to a term. If the name has no meaning in the model, the result is invalid, and
/// `reason` receives the reason.
Id<Expr> leaf_of(const LoopMeaning& meaning, const ClosedLoop::Symbol& symbol, std::string& reason) {
    const ClosedLoop& loop = meaning.loop;
    const Draft& main = meaning.main.draft;
    return std::visit(
        overloaded{
            [&](const ClosedLoop::SharedSymbol& of) -> Id<Expr> {
                if (meaning.shared[of.shared.index].valid()) return main.leaf(meaning.shared[of.shared.index]);
                reason = "`" + loop.shared[of.shared].name + "` is a variable of the plant, which this model omits";
                return {};
            },
            [&](const ClosedLoop::InternalSymbol& of) -> Id<Expr> {
                return main.leaf(meaning.variable(of.controller.index, {of.variable.index}));
            },
            [&](const ClosedLoop::StepSymbol& of) -> Id<Expr> {
                const Equations& chart = meaning.equations[of.controller.index];
                return main.leaf(meaning.variable(of.controller.index, chart.steps[of.step.index].variable));
            },
            [&](const ClosedLoop::LocationSymbol& of) -> Id<Expr> {
                if (meaning.at) return meaning.at(of.instance.index, of.location.index);
                const ClosedLoop::Instance& instance = loop.instances[of.instance];
                const Component& component = meaning.model.components[instance.component];
                reason = "`" + instance.name + "." + component.locations[of.location].name +
                         "` is a location of the plant, which this model omits";
                return {};
            },
            [&](const ClosedLoop::OwnSymbol& of) -> Id<Expr> {
                if (meaning.own) return main.leaf(meaning.own(of.instance.index, own_argument(loop, of)));
                const ClosedLoop::Instance& instance = loop.instances[of.instance];
                const Component& component = meaning.model.components[instance.component];
                reason = "`" + instance.name + "." + component.variables[of.variable].name +
                         "` is a variable of the plant, which this model omits";
                return {};
            },
            [&](const ClosedLoop::TimeSymbol& of) -> Id<Expr> {
                const Equations& chart = meaning.equations[of.controller.index];
                return main.leaf(meaning.variable(of.controller.index, end_of(chart, of)));
            },
            [&](const ClosedLoop::ObserverSymbol& of) -> Id<Expr> {
                reason = meaning.unobserved[of.observer.index];
                return reason.empty() ? main.is(meaning.observers[of.observer.index], of.location.index) : Id<Expr>{};
            },
        },
        symbol);
}

/// Returns the reason why the property cannot be decided on this model, or an empty string if it can be decided.
std::string refusal(const LoopMeaning& meaning, const Property& property) {
    switch (property.pattern) {
    case Pattern::Watched:
        return property.watch.duration_ms > 0
                   ? "the property requires time, which this model does not have; use the timed "
                     "engine, or --plant automata --schedule interleaved --time discrete"
                   : "the observer of the property is supported only in the timed model and with --plant "
                     "automata --schedule interleaved";
    case Pattern::NoDeadlock:
        return meaning.can_move.valid()
                   ? ""
                   : "the transition relation of this model is total, even if the closed loop can deadlock";
    case Pattern::NoTimelock: return meaning.can_wait.valid() ? "" : "this model has no time";
    case Pattern::RawUppaal: return "UPPAAL formulas require UPPAAL";
    case Pattern::Always:
    case Pattern::Never:
    case Pattern::Reachable:
    case Pattern::Inevitable:
    case Pattern::LeadsTo:
    case Pattern::ReachableAllSteps:
    case Pattern::ExactlyOneOf:
    case Pattern::AlwaysPossible:
    case Pattern::RawCtl:
    case Pattern::RawLtl: return {};
    }
    unreachable();
}

/// Adds a property `reachable` for each step, with the name `PROP.X7` or, if there are several controllers,
/// `PROP.chart.X7`.
void add_all_steps(const LoopMeaning& meaning, const Property& property) {
    for (std::size_t controller = 0; controller < meaning.equations.size(); ++controller) {
        const Equations& equations = meaning.equations[controller];
        const std::string chart = meaning.equations.size() > 1 ? equations.name + "." : "";
        for (const Equations::StepActivity& step : equations.steps) {
            Property one = property;
            one.name = property.name + "." + chart + step.step.variable();
            one.pattern = Pattern::Reachable;
            one.operands = {meaning.main.draft.leaf(meaning.variable(controller, step.variable))};
            meaning.main.system.properties.add(std::move(one));
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
    return translate(loop.exprs, expr, meaning.main.system.exprs,
                     [&](const Expr& leaf) { return leaf_of(meaning, symbol_of(leaf), reason); });
}

void add_property(const LoopMeaning& meaning, const Property& property) {
    TransitionSystem& system = meaning.main.system;
    std::string reason = refusal(meaning, property);
    Property translated = property;
    translated.operands.clear();
    for (std::size_t k = 0; reason.empty() && k < property.operands.size(); ++k)
        translated.operands.push_back(term_of(meaning, property.operands[k], reason));
    if (!reason.empty()) {
        translated.operands.clear();
        system.omitted.push_back({std::move(translated), std::move(reason), system.properties.size()});
        return;
    }
    if (meaning.checked_when_stable) translated.at_stable = true;
    if (property.pattern == Pattern::ReachableAllSteps) return add_all_steps(meaning, translated);
    if (property.pattern == Pattern::NoDeadlock || property.pattern == Pattern::NoTimelock) {
        // `no deadlock` requires that an edge can be taken immediately or after a delay. Until an edge is enabled, the
        // only possible event is the passage of time, so that there is only one run. Therefore `always possible` has
        // the same meaning as `no deadlock`.
        translated.pattern = Pattern::AlwaysPossible;
        translated.operands = {property.pattern == Pattern::NoDeadlock ? meaning.can_move : meaning.can_wait};
    }
    system.properties.add(std::move(translated));
}

void add_never(TransitionSystem& system, const std::string& name, std::string text,
               const std::vector<Id<Expr>>& flags) {
    if (flags.empty()) return;
    Property property;
    property.name = name;
    const auto taken = [&](const Property& other) { return other.name == property.name; };
    for (int number = 2; std::ranges::any_of(system.properties, taken); ++number)
        property.name = name + "_" + std::to_string(number);
    property.text = std::move(text);
    property.pattern = Pattern::Never;
    property.operands = {system.exprs.disjunction(flags)};
    system.properties.add(std::move(property));
}

}  // namespace grafverif::schedule
