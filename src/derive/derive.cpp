// SPDX-License-Identifier: MIT
// The equations (11) and (12) of CEP13, timers and the variables of all equations; outputs and stored actions have
// files of their own.
#include "grafverif/derive/derive.hpp"

#include <array>
#include <map>

#include "derivation.hpp"
#include "grafverif/syntax/dialect.hpp"
#include "support/unique_names.hpp"
#include "unsupported.hpp"

namespace grafverif {

namespace {

using Role = Equations::Role;

Role role(Chart::VariableKind kind) {
    switch (kind) {
    case Chart::VariableKind::Input: return Role::Input;
    case Chart::VariableKind::Output: return Role::Output;
    case Chart::VariableKind::Internal: return Role::Internal;
    }
    return Role::Input;
}

/// `G2` + `separator` for a step of the named partial chart G2, else nothing.
std::string qualifier(const Chart& chart, Id<Chart::Step> step, char separator) {
    const Id<Chart::PartialChart> partial = chart.steps[step].chart;
    if (!partial.valid() || chart.partial_charts[partial].name.empty()) return {};
    return chart.partial_charts[partial].name + separator;
}

void add_variables(Derivation& derivation, UniqueNames& names) {
    const Chart& chart = derivation.chart;
    Equations& equations = derivation.equations;
    for (const Chart::Variable& variable : chart.variables)
        equations.variables.add({names.fresh(variable.name), role(variable.kind), variable.type, variable.initial,
                                 variable.origin});
    for (const Id<Chart::Step> id : chart.steps.ids()) {
        const Chart::Step& step = chart.steps[id];
        const std::string name = names.fresh("X_" + qualifier(chart, id, '_') + step.name);
        derivation.steps.push_back(equations.variables.add({name, Role::Step, {}, step.initial ? 1 : 0, step.origin}));
        derivation.step_leaves.push_back(variable_leaf(derivation, derivation.steps.back()));
    }
    for (const Chart::Transition& transition : chart.transitions) {
        derivation.firings.push_back(equations.variables.add(
            {names.fresh("CF_" + transition.name), Role::FiringCondition, {}, 0, transition.origin}));
        derivation.firing_leaves.push_back(variable_leaf(derivation, derivation.firings.back()));
    }
}

/// Per time condition: whether a transition waits for it, after all that folding left of its condition. Operands
/// precede the terms they stand in, so one pass from the back suffices.
std::vector<bool> awaited(const Chart& chart) {
    std::vector<bool> needed(chart.exprs.size());
    for (const Chart::Transition& transition : chart.transitions) needed[transition.condition.index] = true;
    std::vector<bool> result(chart.time_conditions.size());
    for (auto index = static_cast<std::uint32_t>(chart.exprs.size()); index-- > 0;) {
        if (!needed[index]) continue;
        const Id<Expr> term{index};
        if (chart.exprs[term].op == Op::Timed) result[static_cast<std::size_t>(chart.exprs[term].value)] = true;
        for (const Id<Expr> operand : chart.exprs.operands(term)) needed[operand.index] = true;
    }
    return result;
}

/// One timer per step and duration (CEP13 Fig. 33b), in order of first use.
void add_timers(Derivation& derivation, UniqueNames& names) {
    const Chart& chart = derivation.chart;
    Equations& equations = derivation.equations;
    std::map<std::pair<std::int64_t, std::int64_t>, Id<Equations::Variable>> known;   // by step and duration
    const std::vector<bool> wanted = awaited(chart);
    derivation.ends.resize(chart.time_conditions.size());
    for (const Id<Chart::TimeCondition> id : chart.time_conditions.ids()) {
        if (!wanted[id.index]) continue;
        const Chart::TimeCondition& timed = chart.time_conditions[id];
        const std::int64_t watched = chart.exprs[timed.watched].value;
        const auto [place, added] = known.try_emplace({watched, timed.rise_ms});
        if (added) {
            const Id<Chart::Step> step{static_cast<std::uint32_t>(watched)};
            const std::string name = names.fresh("T_" + qualifier(chart, step, '_') + "X" + chart.steps[step].name +
                                                 "_" + duration_text(timed.rise_ms));
            place->second = equations.variables.add({names.fresh(name + "_Q"), Role::TimerEnd, {}, 0, timed.origin});
            equations.timers.push_back(
                {name, derivation.steps[step.index], place->second, timed.rise_ms, timed.origin});
        }
        derivation.ends[id.index] = place->second;
    }
}

void index_actions(Derivation& derivation) {
    const Chart& chart = derivation.chart;
    derivation.continuous.resize(chart.variables.size());
    derivation.stored.resize(chart.variables.size());
    derivation.values.resize(chart.variables.size());
    for (const Id<Chart::ContinuousAction> id : chart.continuous.ids())
        derivation.continuous[chart.continuous[id].output.index].push_back(id);
    for (const Id<Chart::StoredAction> id : chart.stored.ids())
        derivation.stored[chart.stored[id].target.index].push_back(id);
    derivation.reads_output.resize(chart.exprs.size());
    for (std::uint32_t index = 0; index < chart.exprs.size(); ++index) {
        const Expr& node = chart.exprs[Id<Expr>{index}];
        bool reads = node.op == Op::Variable &&
                     is_continuous(derivation, Id<Chart::Variable>{static_cast<std::uint32_t>(node.value)});
        for (const Id<Expr> operand : chart.exprs.operands(Id<Expr>{index}))
            reads = reads || derivation.reads_output[operand.index];
        derivation.reads_output[index] = reads;
    }
}

/// Equation (11): all steps upstream are active and the condition holds.
void derive_firings(Derivation& derivation) {
    const Chart& chart = derivation.chart;
    Exprs& exprs = derivation.equations.exprs;
    for (const Id<Chart::Transition> id : chart.transitions.ids()) {
        const Chart::Transition& transition = chart.transitions[id];
        std::vector<Id<Expr>> operands;
        for (const Id<Chart::Step> step : transition.from)
            operands.push_back(derivation.step_leaves[step.index]);
        const Id<Expr> condition = over_equations(derivation, transition.condition, transition.origin,
                                                  "transition `" + transition.name + "`");
        if (condition.valid()) operands.push_back(condition);
        derivation.equations.firings.push_back(
            {derivation.firings[id.index], exprs.conjunction(operands), transition.name, transition.origin});
        if (derivation.diagnostics.full() || derivation.exhausted) return;
    }
}

/// Equation (12); activation has priority over deactivation (IEC 60848, rule 5), and a step that is activated and
/// deactivated at once stays active: it is neither `activated` nor `deactivated`.
void derive_steps(Derivation& derivation) {
    const Chart& chart = derivation.chart;
    Exprs& exprs = derivation.equations.exprs;
    std::vector<std::vector<Id<Expr>>> activating(chart.steps.size());
    std::vector<std::vector<Id<Expr>>> deactivating(chart.steps.size());
    for (const Id<Chart::Transition> id : chart.transitions.ids()) {
        const Id<Expr> fires = derivation.firing_leaves[id.index];
        for (const Id<Chart::Step> step : chart.transitions[id].from) deactivating[step.index].push_back(fires);
        for (const Id<Chart::Step> step : chart.transitions[id].to) activating[step.index].push_back(fires);
    }
    for (const Id<Chart::Step> id : chart.steps.ids()) {
        const Id<Expr> active = derivation.step_leaves[id.index];
        const Id<Expr> on = exprs.disjunction(activating[id.index]);
        const Id<Expr> off = exprs.disjunction(deactivating[id.index]);
        const Id<Expr> not_off = exprs.negation(off);
        const std::array<Id<Expr>, 3> left{active, off, exprs.negation(on)};
        derivation.equations.steps.push_back({derivation.steps[id.index],
                                              exprs.disjunction(on, exprs.conjunction(active, not_off)),
                                              exprs.conjunction(on, exprs.negation(active)),
                                              consistent(exprs, exprs.conjunction(left)),
                                              qualifier(chart, id, '.') + chart.steps[id].name,
                                              chart.steps[id].origin});
    }
}

/// Nothing would change in one more cycle with the same inputs. While stored actions are triggered by step changes
/// alone, no variable changes where no transition fires; edges and events will add their previous values here.
Id<Expr> stable(Derivation& derivation) {
    Exprs& exprs = derivation.equations.exprs;
    std::vector<Id<Expr>> fires;
    for (std::size_t k = 0; k < derivation.equations.firings.size(); ++k)
        if (!is_false(exprs, derivation.equations.firings[k].condition)) fires.push_back(derivation.firing_leaves[k]);
    return exprs.negation(exprs.disjunction(fires));
}

/// The variables of the equations begin with those of the chart, so inputs keep their index.
void derive_assumptions(Derivation& derivation) {
    Exprs& exprs = derivation.equations.exprs;
    for (const Chart::Constraint& constraint : derivation.chart.constraints) {
        const Id<Expr> condition =
            translate(derivation.chart.exprs, constraint.condition, exprs,
                      [&](const Expr& leaf) { return exprs.leaf(leaf.op, static_cast<std::uint32_t>(leaf.value)); });
        derivation.equations.assumptions.push_back({condition, constraint.origin});
    }
}

}  // namespace

std::optional<Equations> derive(const Chart& chart, Diagnostics& diagnostics) {
    if (unsupported(chart, diagnostics)) return {};
    Derivation derivation{chart, diagnostics};
    derivation.errors_before = diagnostics.errors();
    derivation.equations.name = chart.name;
    derivation.equations.origin = chart.origin;
    UniqueNames names;
    add_variables(derivation, names);
    add_timers(derivation, names);
    index_actions(derivation);
    derive_outputs(derivation);
    if (failed(derivation)) return {};
    derive_firings(derivation);
    derive_steps(derivation);
    if (failed(derivation)) return {};
    derive_stored(derivation);
    derivation.equations.stable = stable(derivation);
    derive_assumptions(derivation);
    if (failed(derivation)) return {};
    return std::move(derivation.equations);
}

}  // namespace grafverif
