// SPDX-License-Identifier: MIT
// Resolves a chart: variables first, then steps, then the declarations that refer to both.
#include <algorithm>

#include "grafverif/ir/finding.hpp"
#include "support/messages.hpp"
#include "syntax/resolve/chart_scope.hpp"
#include "syntax/resolve/resolve.hpp"

namespace grafverif {

namespace {

/// True if `condition` reads only inputs and current values. Reports the first violation otherwise.
bool reads_inputs_only(ChartScope& scope, Id<Expr> condition, Span where) {
    const Chart& chart = scope.chart;
    std::vector<Id<Expr>> open{condition};
    while (!open.empty()) {
        const Expr& node = chart.exprs[open.back()];
        const auto index = static_cast<std::uint32_t>(node.value);
        std::string other;
        if (node.op == Op::Rise || node.op == Op::Fall) other = "an edge";
        if (node.op == Op::Timed) other = "a time condition";
        if (node.op == Op::Step) other = "`" + step_variable(chart, {index}) + "`";
        if (node.op == Op::Variable && chart.variables[{index}].kind != Chart::VariableKind::Input)
            other = "`" + chart.variables[{index}].name + "`";
        if (!other.empty()) {
            scope.diagnostics.add(messages::constraint_not_on_inputs(where, other));
            return false;
        }
        const auto operands = chart.exprs.operands(open.back());
        open.pop_back();
        open.insert(open.end(), operands.begin(), operands.end());
    }
    return true;
}

/// Records the transition, variable or step that `accept CODE SUBJECT` names. An unknown subject is not an error here,
/// because the analysis reports each acceptance without a finding.
void record_subject(const ChartScope& scope, const tree::Accept& written, const WrittenChart& all) {
    const Chart& chart = scope.chart;
    const std::string_view subject = written.subject;
    const std::size_t dot = subject.rfind('.') + 1;  // 0 if there is no dot, because npos + 1 is 0
    const std::string_view name = subject.substr(dot), partial = subject.substr(0, dot == 0 ? 0 : dot - 1);
    const Span where = last_name(written.subject_where, name);
    for (const WrittenTransition& each : all.transitions)
        if (dot == 0 && each.transition->name.valid() && scope.text(each.transition->name) == name)
            return scope.record.refer(where, each.transition->name.where);
    for (const Chart::Variable& variable : chart.variables)
        if (dot == 0 && variable.name == name) return scope.record.refer(where, variable.origin);
    for (const Id<Chart::Step> step : chart.steps.ids()) {
        if (step_variable(chart, step) != subject) continue;
        const Chart::PartialChart& owner = chart.partial_charts[chart.steps[step].chart];
        scope.record.refer(where, chart.steps[step].origin);
        const std::uint32_t begin = written.subject_where.begin,
                            end = begin + static_cast<std::uint32_t>(partial.size());
        if (dot != 0) scope.record.refer({where.source, begin, end}, owner.origin);
        return;
    }
}

void resolve_acceptance(ChartScope& scope, const tree::Accept& written, const WrittenChart& all) {
    if (std::ranges::find(finding_kinds(), written.code, &FindingKind::code) == finding_kinds().end())
        scope.diagnostics.add(messages::unknown_finding(written.where, written.code));
    record_subject(scope, written, all);
    scope.chart.accepted.push_back({written.code, written.subject, written.reason, written.where});
}

}  // namespace

std::optional<Chart> resolve_chart(const tree::File& file, const tree::Chart& written, Diagnostics& diagnostics,
                                   Recorder record) {
    const std::size_t errors = diagnostics.errors();
    ChartScope scope{file, diagnostics, record};
    scope.chart.name = file.text(written.name);
    scope.chart.origin = written.name.where;
    record.declare(DeclarationKind::Chart, scope.chart.name, written.name.where, written.where);
    for (const tree::ChartItem& item : written.items)
        if (const auto* variables = std::get_if<tree::Variables>(&item)) resolve_variables(scope, *variables);
    const WrittenChart all = declare_steps(scope, written);
    if (all.steps.empty()) diagnostics.add(messages::empty_chart(written.name.where, scope.chart.name));
    check_step_like(scope);
    resolve_owners(scope, all);
    resolve_actions(scope, all);
    resolve_transitions(scope, all);
    for (const tree::ChartItem& item : written.items) {
        const auto* constraint = std::get_if<tree::Constraint>(&item);
        if (constraint == nullptr) continue;
        const Id<Expr> condition = resolve_condition(scope, constraint->condition, {}, "a constraint");
        if (condition.valid() && reads_inputs_only(scope, condition, constraint->where))
            scope.chart.constraints.push_back({condition, constraint->where});
    }
    for (const tree::ChartItem& item : written.items)
        if (const auto* accept = std::get_if<tree::Accept>(&item)) resolve_acceptance(scope, *accept, all);
    if (record.beyond_errors()) return std::move(scope.chart);
    if (diagnostics.errors() != errors) return {};
    check_reachability(scope.chart, diagnostics);
    if (diagnostics.errors() != errors) return {};
    return std::move(scope.chart);
}

}  // namespace grafverif
