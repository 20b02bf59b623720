// SPDX-License-Identifier: MIT
// Entry point of the derivation of equations: declares the variables of the equations, derives the equations of
// outputs, firing conditions, steps and stored variables in this order, and derives the stability condition.
#include "derive/derive.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "derivation.hpp"
#include "grafverif/ir/chart.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"

namespace grafverif {

namespace {

/// For each term of a chart: its properties with respect to edges of signals.
struct Edges {
    std::vector<bool> occur = {};   ///< true if the term contains an edge
    std::vector<bool> needed = {};  ///< true if the term is false whenever no edge occurs
    std::vector<bool> nested = {};  ///< true if the term contains an edge of an edge

    /// True if the term reads an edge and can become true or undefined in a later cycle in which no signal has an edge.
    std::vector<bool> after = {};
};

bool needs_edge(const Exprs& exprs, Id<Expr> term, const std::vector<bool>& needed) {
    const std::span<const Id<Expr>> operands = exprs.operands(term);
    const auto needs = [&](Id<Expr> operand) -> bool { return needed[operand.index]; };
    switch (exprs[term].op) {
    case Op::Rise:
    case Op::Fall:
    case Op::False: return true;
    case Op::And: return std::ranges::any_of(operands, needs);
    case Op::Or: return std::ranges::all_of(operands, needs);
    default: return false;
    }
}

/// Determines the properties of all terms in one pass. One pass is sufficient, because operands precede the terms that
/// contain them.
Edges edges(const Exprs& exprs) {
    const std::vector<bool> none(exprs.size());
    Edges result{none, none, none, none};
    std::vector<bool> partial = none;  // true if the term can be undefined
    for (std::uint32_t index = 0; index < exprs.size(); ++index) {
        const Id<Expr> id{index};
        const bool is_edge = exprs[id].op == Op::Rise || exprs[id].op == Op::Fall;
        const bool is_monotone = is_edge || exprs[id].op == Op::And || exprs[id].op == Op::Or;
        result.occur[index] = is_edge;
        for (const Id<Expr> operand : exprs.operands(id)) {
            if (result.after[operand.index] || (!is_monotone && result.occur[operand.index]))
                result.after[index] = true;
            if (result.occur[operand.index]) result.occur[index] = true;
            if (result.nested[operand.index] || (is_edge && result.occur[operand.index])) result.nested[index] = true;
        }
        partial[index] = is_arithmetic(exprs[id].op);
        for (const Id<Expr> operand : exprs.operands(id)) partial[index] = partial[index] || partial[operand.index];
        result.after[index] = result.after[index] || (partial[index] && result.occur[index]);
        result.needed[index] = needs_edge(exprs, id, result.needed);
    }
    return result;
}

/// Reports each edge that IEC 60848 forbids, and each event whose term does not require an edge.
struct Refusal {
    const Chart& chart;
    Diagnostics& diagnostics;
    Edges edge;

    void time_conditions() const {
        for (const Chart::TimeCondition& timed : chart.time_conditions)
            if (edge.occur[timed.watched.index]) diagnostics.add(messages::edge_under_time(timed.origin));
    }

    void edges_of_edges() const {
        for (const Chart::Transition& transition : chart.transitions)
            if (edge.nested[transition.condition.index]) diagnostics.add(messages::edge_of_edge(transition.origin));
        for (const Chart::StoredAction& action : chart.stored)
            if (edge.nested[action.value.index] || (action.event.valid() && edge.nested[action.event.index]))
                diagnostics.add(messages::edge_of_edge(action.origin));
    }

    /// Reports edges in assignation conditions, because an action whose condition contains an edge would not be
    /// continuous.
    void continuous_actions() const {
        for (const Chart::ContinuousAction& action : chart.continuous)
            if (edge.occur[action.condition.index])
                diagnostics.add(messages::edge_in_assignation(action.origin, chart.variables[action.output].name));
    }

    /// Reports events whose term can be true without an edge. An event is instantaneous, so that its term must require
    /// an edge.
    void events() const {
        for (const Chart::StoredAction& action : chart.stored)
            if (action.on == Chart::StoredOn::Event && !edge.needed[action.event.index])
                diagnostics.add(messages::event_without_edge(action.origin, chart.variables[action.target].name));
    }
};

/// Reports forbidden edges, and events that do not require an edge. Returns true if at least one error was reported.
bool misplaced_edges(const Chart& chart, Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    const Refusal refusal{chart, diagnostics, edges(chart.exprs)};
    refusal.time_conditions();
    refusal.edges_of_edges();
    refusal.continuous_actions();
    refusal.events();
    return diagnostics.errors() != errors;
}

using Role = Equations::Role;

Role role(Chart::VariableKind kind) {
    switch (kind) {
    case Chart::VariableKind::Input: return Role::Input;
    case Chart::VariableKind::Output: return Role::Output;
    case Chart::VariableKind::Internal: return Role::Internal;
    }
    return Role::Input;
}

void add_variables(Derivation& derivation) {
    UniqueNames& names = derivation.names;
    const Chart& chart = derivation.chart;
    Equations& equations = derivation.equations;
    for (const Chart::Variable& variable : chart.variables)
        equations.variables.add(
            {names.fresh(variable.name), role(variable.kind), variable.type, variable.initial, variable.origin});
    for (const Id<Chart::Step> id : chart.steps.ids()) {
        const Chart::Step& step = chart.steps[id];
        const std::string name = names.fresh("X_" + qualifier(name_of(chart, id)) + step.name);
        const bool initial = derivation.hierarchy.initial[id.index];
        derivation.steps.push_back(equations.variables.add({name, Role::Step, {}, initial ? 1 : 0, step.origin}));
        derivation.step_leaves.push_back(variable_leaf(derivation, derivation.steps.back()));
    }
    for (const Chart::Transition& transition : chart.transitions) {
        derivation.firings.push_back(equations.variables.add(
            {names.fresh("CF_" + transition.name), Role::FiringCondition, {}, 0, transition.origin}));
        derivation.firing_leaves.push_back(variable_leaf(derivation, derivation.firings.back()));
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
        if (node.op == Op::Timed) {  // the observed term was processed earlier, because it precedes the time condition
            const Id<Chart::TimeCondition> timed{static_cast<std::uint32_t>(node.value)};
            reads = derivation.reads_output[chart.time_conditions[timed].watched.index];
        }
        for (const Id<Expr> operand : chart.exprs.operands(Id<Expr>{index}))
            reads = reads || derivation.reads_output[operand.index];
        derivation.reads_output[index] = reads;
    }
}

/// Returns the stability condition, which is true if one more cycle with the same inputs changes nothing. A stored
/// value changes only when a transition is cleared, when a step changes (which requires that a transition is cleared),
/// or at an event. From power-on, forced and enclosed charts are consistent with their forcing orders and enclosing
/// steps. These charts change only when one of these orders or steps changes. In one more cycle, no signal has an edge;
/// therefore, a condition such as `!rise(a)` can become true.
Id<Expr> stable(Derivation& derivation) {
    const Chart& chart = derivation.chart;
    const Equations& equations = derivation.equations;
    Exprs& exprs = derivation.equations.exprs;
    std::vector<Id<Expr>> changes;
    for (std::size_t k = 0; k < equations.firings.size(); ++k)
        if (!is_false(exprs, equations.firings[k].condition)) changes.push_back(derivation.firing_leaves[k]);
    const Edges edge = edges(chart.exprs);
    for (const Chart::Transition& transition : chart.transitions)
        if (edge.after[transition.condition.index])
            changes.push_back(clearing_condition(derivation, transition, TermPosition::First));
    for (const Chart::StoredAction& action : chart.stored)
        if (action.on == Chart::StoredOn::Event) changes.push_back(trigger_of(derivation, action));
    if (failed(derivation)) return exprs.constant(true);
    return exprs.negation(exprs.disjunction(changes));
}

/// Copies the constraints of the chart. The indices of the inputs do not change, because the variables of the chart
/// precede all other variables of the equations.
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

std::string qualifier(const StepName& step) { return step.partial.empty() ? "" : step.partial + "_"; }

std::optional<Equations> derive(const Chart& chart, Diagnostics& diagnostics) {
    if (chart.program) {
        diagnostics.add(messages::only_for_charts(
            chart.origin, chart.name, "this operation requires a chart with steps",
            "check the program in a closed loop, or pass its file and `--properties` to `check`"));
        return {};
    }
    if (misplaced_edges(chart, diagnostics)) return {};
    Derivation derivation{chart, diagnostics};
    derivation.errors_before = diagnostics.errors();
    auto resolved = hierarchy(chart, diagnostics);
    if (!resolved) return {};
    derivation.hierarchy = std::move(*resolved);
    derivation.equations.name = chart.name;
    derivation.equations.origin = chart.origin;
    derivation.equations.conditions.resize(chart.time_conditions.size());
    add_variables(derivation);
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
