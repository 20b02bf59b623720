// SPDX-License-Identifier: MIT
// Resolves the actions of the steps of a chart: continuous actions, stored actions and forcing orders.
#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/resolve/chart_scope.hpp"
#include "syntax/resolve/expand.hpp"
#include "syntax/resolve/nearest.hpp"

namespace grafverif {

namespace {

/// Returns the variable that an action assigns. Reports an unknown name.
Id<Chart::Variable> target_of(ChartScope& scope, tree::Name name) {
    const auto found = scope.variables.find(name.word);
    if (found != scope.variables.end())
        return scope.record.refer(name.where, scope.chart.variables[found->second].origin, true), found->second;
    if (scope.diagnostics.full())
        return scope.diagnostics.add(messages::unknown(name.where, "variable", scope.text(name), "")),
               Id<Chart::Variable>{};
    Nearest nearest(scope.text(name));
    const bool in_instance = scope.text(name).find('.') != std::string_view::npos;  // see unknown_name
    for (const Chart::Variable& variable : scope.chart.variables)
        if (variable.kind != Chart::VariableKind::Input && !in_instance) nearest.offer(variable.name);
    scope.diagnostics.add(messages::unknown(name.where, "variable", scope.text(name), nearest.best()));
    return {};
}

/// Records in `mine` the position of an action on `variable`. Reports the first conflict between a
/// continuous action and a stored action on the same variable.
void note_kind(ChartScope& scope, Id<Chart::Variable> variable, std::vector<Span>& mine, const std::vector<Span>& other,
               Span where) {
    if (mine[variable.index].source.valid()) return;
    mine[variable.index] = where;
    if (other[variable.index].source.valid())
        scope.diagnostics.add(
            messages::continuous_and_stored(where, scope.chart.variables[variable].name, other[variable.index]));
}

/// Returns the value of a duration in milliseconds; 0 if the duration is omitted, or after an error.
std::int64_t duration_of(ChartScope& scope, Id<tree::Expr> node) {
    if (!node.valid()) return 0;
    Terms terms = terms_of(scope);
    const auto value = terms.constant(node, TermKind::Duration, "a delay or limit");
    if (value && *value == 0) scope.diagnostics.add(messages::zero_duration(scope.file.exprs[node].where));
    return value.value_or(0);
}

void resolve_continuous(ChartScope& scope, const tree::ContinuousAction& written, Id<Chart::Step> step) {
    const Id<Chart::Variable> output = target_of(scope, written.output);
    Chart::ContinuousAction action;
    action.step = step;
    action.output = output;
    action.condition = written.condition.valid()
                           ? resolve_condition(scope, written.condition, scope.here, "an assignation condition")
                           : scope.chart.exprs.constant(true);
    action.delay_ms = duration_of(scope, written.delay);
    action.limit_ms = duration_of(scope, written.limit);
    action.origin = written.where;
    if (!output.valid()) return;
    const Chart::Variable& variable = scope.chart.variables[output];
    if (variable.kind != Chart::VariableKind::Output) {
        const bool input = variable.kind == Chart::VariableKind::Input;
        scope.diagnostics.add(
            messages::not_an_output(written.output.where, variable.name, input ? "input" : "internal"));
        return;
    }
    if (!variable.type.boolean) {
        scope.diagnostics.add(
            messages::type_mismatch(written.output.where, "a continuous action", "a Boolean output", "an integer"));
        return;
    }
    note_kind(scope, output, scope.continuous, scope.stored, written.where);
    scope.chart.continuous.add(std::move(action));
}

void resolve_stored_action(ChartScope& scope, const tree::StoredAction& written, Id<Chart::Step> step) {
    Chart::StoredAction action;
    action.step = step;
    switch (written.when) {
    case tree::StoredWhen::Missing: scope.diagnostics.add(messages::missing_event(written.where)); break;
    case tree::StoredWhen::Activation: action.on = Chart::StoredOn::Activation; break;
    case tree::StoredWhen::Deactivation: action.on = Chart::StoredOn::Deactivation; break;
    case tree::StoredWhen::Event:
        action.on = Chart::StoredOn::Event;
        action.event = resolve_condition(scope, written.event, scope.here, "an event");
        break;
    }
    resolve_stored(scope, written.assignment, action);
}

void resolve_forcing(ChartScope& scope, const tree::ForcingOrder& written, Id<Chart::Step> step) {
    const Id<Chart::PartialChart> forced = partial_named(scope, written.chart);
    if (!forced.valid()) return;
    Chart::ForcingOrder order{step, forced, Chart::ForcedTo::Empty, {}, written.where};
    switch (written.to) {
    case tree::ForcedTo::Empty: order.to = Chart::ForcedTo::Empty; break;
    case tree::ForcedTo::Current: order.to = Chart::ForcedTo::Current; break;
    case tree::ForcedTo::Initial: order.to = Chart::ForcedTo::Initial; break;
    case tree::ForcedTo::Steps: order.to = Chart::ForcedTo::Steps; break;
    }
    for (const tree::Name& label : written.steps) {
        const Id<Chart::Step> member = step_in(scope, forced, label);
        if (member.valid()) order.situation.push_back(member);
    }
    scope.chart.forcing.add(std::move(order));
}

}  // namespace

void resolve_stored(ChartScope& scope, const tree::Assignment& written, Chart::StoredAction action) {
    const Id<Chart::Variable> target = target_of(scope, written.target);
    if (!target.valid()) {
        terms_of(scope).resolve(written.value);
        return;
    }
    const Chart::Variable variable = scope.chart.variables[target];
    if (variable.kind == Chart::VariableKind::Input) {
        scope.diagnostics.add(messages::assigned_input(written.target.where, variable.name));
        return;
    }
    Terms terms = terms_of(scope);
    action.target = target;
    action.value = terms.resolve(written.value, variable.type.boolean ? TermKind::Boolean : TermKind::Integer,
                                 '`' + variable.name + '`');
    action.origin = written.where;
    if (!action.value.valid()) return;
    const Expr& value = scope.chart.exprs[action.value];
    if (value.op == Op::Integer && (value.value < variable.type.low || value.value > variable.type.high)) {
        scope.diagnostics.add(messages::out_of_range(scope.file.exprs[written.value].where, variable.name, value.value,
                                                     variable.type.low, variable.type.high));
        return;
    }
    if (variable.kind == Chart::VariableKind::Output)
        note_kind(scope, target, scope.stored, scope.continuous, written.where);
    scope.chart.stored.add(std::move(action));
}

void resolve_actions(ChartScope& scope, const WrittenChart& written) {
    for (const WrittenStep& step : written.steps) {
        const InChartCopy copy(scope, step.step->name);
        scope.here = scope.chart.steps[step.id].chart;
        for (const tree::Action& action : step.step->actions) {
            std::visit(
                overloaded{
                    [&](const tree::ContinuousAction& continuous) { resolve_continuous(scope, continuous, step.id); },
                    [&](const tree::StoredAction& stored) { resolve_stored_action(scope, stored, step.id); },
                    [&](const tree::ForcingOrder& order) { resolve_forcing(scope, order, step.id); },
                },
                action);
        }
    }
}

}  // namespace grafverif
