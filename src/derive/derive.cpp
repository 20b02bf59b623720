// SPDX-License-Identifier: MIT
// The variables of all equations, what is stable, and the parts of derive in their order.
#include "grafverif/derive/derive.hpp"

#include "derivation.hpp"
#include "misplaced_edges.hpp"

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

void add_variables(Derivation& derivation) {
    UniqueNames& names = derivation.names;
    const Chart& chart = derivation.chart;
    Equations& equations = derivation.equations;
    for (const Chart::Variable& variable : chart.variables)
        equations.variables.add({names.fresh(variable.name), role(variable.kind), variable.type, variable.initial,
                                 variable.origin});
    for (const Id<Chart::Step> id : chart.steps.ids()) {
        const Chart::Step& step = chart.steps[id];
        const std::string name = names.fresh("X_" + qualifier(chart, id, '_') + step.name);
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
        if (node.op == Op::Timed) {   // what it watches precedes it
            const Id<Chart::TimeCondition> timed{static_cast<std::uint32_t>(node.value)};
            reads = derivation.reads_output[chart.time_conditions[timed].watched.index];
        }
        for (const Id<Expr> operand : chart.exprs.operands(Id<Expr>{index}))
            reads = reads || derivation.reads_output[operand.index];
        derivation.reads_output[index] = reads;
    }
}

/// Nothing would change in one more cycle with the same inputs. Variables are stored on clearing, on changes of steps,
/// which need a clearing too, and on events, which need an edge. What is forced or enclosed is as its order or its
/// enclosing step has it from power-on on, and changes with those alone.
Id<Expr> stable(Derivation& derivation) {
    const Equations& equations = derivation.equations;
    Exprs& exprs = derivation.equations.exprs;
    std::vector<Id<Expr>> changes;
    for (std::size_t k = 0; k < equations.firings.size(); ++k)
        if (!is_false(exprs, equations.firings[k].condition)) changes.push_back(derivation.firing_leaves[k]);
    for (const Equations::Previous& previous : equations.previous)
        changes.push_back(exprs.apply(Op::NotEqual, previous.value, variable_leaf(derivation, previous.variable)));
    return exprs.negation(exprs.disjunction(changes));
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

std::string qualifier(const Chart& chart, Id<Chart::Step> step, char separator) {
    const Id<Chart::PartialChart> partial = chart.steps[step].chart;
    if (!partial.valid() || chart.partial_charts[partial].name.empty()) return {};
    return chart.partial_charts[partial].name + separator;
}

std::optional<Equations> derive(const Chart& chart, Diagnostics& diagnostics) {
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
