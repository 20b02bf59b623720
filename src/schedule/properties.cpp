// SPDX-License-Identifier: MIT
// A property that reads only inputs, outputs, internals and steps is asked of the controllers alone; every other one is
// left out, with the reason that the model prints in its place.
#include "schedule/properties.hpp"

#include <optional>

#include "grafverif/support/overloaded.hpp"

namespace grafverif::schedule {

Members members(TransitionSystem& system, std::span<const ControllerModule> controllers) {
    Members result{system, controllers};
    for (const TransitionSystem::Instance& instance : system.instances)
        result.known.emplace_back(system.modules[instance.module].symbols.size());
    return result;
}

Id<Symbol> member(Members& members, std::size_t controller, Id<Symbol> symbol) {
    Id<Symbol>& known = members.known[controller][symbol.index];
    if (known.valid()) return known;
    TransitionSystem& system = members.system;
    const Id<TransitionSystem::Instance> id{static_cast<std::uint32_t>(controller)};
    const TransitionSystem::Instance& instance = system.instances[id];
    const Symbol& inner = system.modules[instance.module].symbols[symbol];
    known = system.modules[system.main].symbols.add({instance.name + "." + inner.name, inner.type,
                                                     TransitionSystem::MemberSymbol{id, symbol}, "", inner.origin});
    return known;
}

namespace {

struct Translation {
    Members& members;
    const Model& model;
    const ClosedLoop& loop;
    std::span<const Equations> equations;
    std::span<const Id<Symbol>> shared;
};

/// The symbol of main that a name in a property stands for, or why there is none.
struct Meaning {
    Id<Symbol> symbol = {};
    std::string reason = {};
};

Meaning meaning(Translation& translation, const ClosedLoop::Symbol& symbol) {
    Members& members = translation.members;
    const ClosedLoop& loop = translation.loop;
    return std::visit(overloaded{
        [&](const ClosedLoop::SharedSymbol& of) -> Meaning {
            const Id<Symbol> known = translation.shared[of.shared.index];
            if (known.valid()) return {known, {}};
            return {{}, "`" + loop.shared[of.shared].name + "` is a variable of the plant"};
        },
        [&](const ClosedLoop::InternalSymbol& of) -> Meaning {
            const std::size_t controller = of.controller.index;
            const Id<Symbol> inner = members.controllers[controller].symbols[of.variable.index];
            return {member(members, controller, inner), {}};
        },
        [&](const ClosedLoop::StepSymbol& of) -> Meaning {
            const std::size_t controller = of.controller.index;
            const Id<Equations::Variable> activity = translation.equations[controller].steps[of.step.index].variable;
            return {member(members, controller, members.controllers[controller].symbols[activity.index]), {}};
        },
        [&](const ClosedLoop::LocationSymbol& of) -> Meaning {
            const ClosedLoop::Instance& instance = loop.instances[of.instance];
            const Component& component = translation.model.components[instance.component];
            return {{},
                    "`" + instance.name + "." + component.locations[of.location].name + "` is a location of the plant"};
        },
    }, symbol);
}

/// `operand` over the symbols of main; or nothing, and `reason` says why.
std::optional<Id<Expr>> operand_of(Translation& translation, Id<Expr> operand, std::string& reason) {
    const auto symbol_of = [&](const Expr& leaf) -> const ClosedLoop::Symbol& {
        return translation.loop.symbols[{static_cast<std::uint32_t>(leaf.value)}];
    };
    for (const Id<Expr> leaf : leaves(translation.loop.exprs, operand)) {
        reason = meaning(translation, symbol_of(translation.loop.exprs[leaf])).reason;
        if (!reason.empty()) return {};
    }
    Exprs& exprs = translation.members.system.exprs;
    return translate(translation.loop.exprs, operand, exprs, [&](const Expr& leaf) {
        return exprs.leaf(Op::Variable, meaning(translation, symbol_of(leaf)).symbol.index);
    });
}

/// Why the pattern as such is no question to an untimed model of the controllers alone; empty: it is one.
std::string refusal(Pattern pattern) {
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

/// One `reachable` per step, named `PROP.X7`; with several controllers `PROP.chart.X7`.
void add_all_steps(Translation& translation, const Property& property) {
    Members& members = translation.members;
    for (std::size_t controller = 0; controller < translation.equations.size(); ++controller) {
        const std::string& chart = translation.equations[controller].name;
        const std::string prefix = property.name + (translation.equations.size() > 1 ? "." + chart : "") + ".";
        for (const Equations::StepActivity& step : translation.equations[controller].steps) {
            const Id<Symbol> activity = members.controllers[controller].symbols[step.variable.index];
            const Id<Symbol> symbol = member(members, controller, activity);
            Property one = property;
            const std::size_t dot = step.step.rfind('.');
            const std::size_t own = dot == std::string::npos ? 0 : dot + 1;
            one.name = prefix + step.step.substr(0, own) + "X" + step.step.substr(own);
            one.pattern = Pattern::Reachable;
            one.operands = {members.system.exprs.leaf(Op::Variable, symbol.index)};
            members.system.properties.add(std::move(one));
        }
    }
}

void add_property(Translation& translation, const Property& property) {
    TransitionSystem& system = translation.members.system;
    std::string reason = refusal(property.pattern);
    Property translated = property;
    translated.operands.clear();
    for (std::size_t k = 0; reason.empty() && k < property.operands.size(); ++k)
        if (const auto operand = operand_of(translation, property.operands[k], reason))
            translated.operands.push_back(*operand);
    if (!reason.empty()) {
        translated.operands.clear();
        system.omitted.push_back({std::move(translated), std::move(reason), system.properties.size()});
        return;
    }
    if (property.pattern == Pattern::ReachableAllSteps) add_all_steps(translation, property);
    else system.properties.add(std::move(translated));
}

/// `name`: never one of `flags`.
void add_never(Members& members, std::string name, std::string text, const std::vector<Id<Expr>>& flags) {
    if (flags.empty()) return;
    Property property;
    property.name = std::move(name);
    property.text = std::move(text);
    property.pattern = Pattern::Never;
    property.operands = {members.system.exprs.disjunction(flags)};
    members.system.properties.add(std::move(property));
}

}  // namespace

void add_properties(Members& members, const Model& model, const ClosedLoop& loop, std::span<const Equations> equations,
                    std::span<const Id<Symbol>> shared) {
    Translation translation{members, model, loop, equations, shared};
    for (const Property& property : loop.properties) add_property(translation, property);
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
    add_never(members, "no_race", "no two stored actions write different values to one variable in one cycle", races);
    const std::string text = bounded.empty() ? "nothing is divided by zero"
                                             : "no assignment leaves the range of its variable: " + bounded;
    add_never(members, "no_out_of_range", text, ranges);
}

}  // namespace grafverif::schedule
