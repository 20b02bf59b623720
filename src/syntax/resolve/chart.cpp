// SPDX-License-Identifier: MIT
// Resolves a chart: variables first, then steps, then the declarations that refer to both.
#include <algorithm>
#include <string>
#include <unordered_map>

#include "grafverif/ir/finding.hpp"
#include "support/messages.hpp"
#include "syntax/resolve/chart_scope.hpp"
#include "syntax/resolve/expand.hpp"
#include "syntax/resolve/resolve.hpp"

namespace grafverif {

namespace {

/// True if `condition` reads only current values of inputs. Otherwise, reports the first leaf or edge that is not
/// allowed.
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

/// The positions of the elements that a declaration `accept` can name, such as `t1`, `OPEN`, `X2` or `G2.X2`. The key
/// of the partial chart `G2` is `G2.`.
using Subjects = std::unordered_map<std::string, Span>;

/// Returns the elements of a chart that `accept` can name. If a transition and a variable have the same name, the name
/// denotes the transition.
Subjects subjects_of(const ChartScope& scope, const WrittenChart& all) {
    const Chart& chart = scope.chart;
    Subjects subjects;
    for (const WrittenTransition& each : all.transitions)
        if (const tree::Name name = each.transition->name; name.valid()) subjects.emplace(scope.text(name), name.where);
    for (const Chart::Variable& variable : chart.variables) subjects.emplace(variable.name, variable.origin);
    for (const Chart::PartialChart& partial : chart.partial_charts)
        subjects.emplace(partial.name + '.', partial.origin);
    for (const Id<Chart::Step> step : chart.steps.ids())
        subjects.emplace(step_variable(chart, step), chart.steps[step].origin);
    return subjects;
}

/// Records the names in the subject of a declaration `accept`. An unknown subject is not an error here, because the
/// analysis reports each `accept` that matches no finding.
void record_subject(const ChartScope& scope, const tree::Accept& written, const Subjects& subjects) {
    const Span where = written.subject_where;
    const std::string& subject = written.subject;
    const std::size_t name = subject.find('.') + 1;  // 0 without a dot, because npos + 1 is 0
    const auto refer = [&](const std::string& key, Span occurrence) {
        if (const auto found = subjects.find(key); found != subjects.end())
            scope.record.refer(occurrence, found->second);
    };
    if (!subjects.contains(subject) || !where.source.valid()) return;
    refer(subject, last_name(where, subject.substr(name)));
    if (name != 0)
        refer(subject.substr(0, name), {where.source, where.begin, where.begin + static_cast<std::uint32_t>(name - 1)});
}

void resolve_acceptance(ChartScope& scope, const tree::Accept& written) {
    if (std::ranges::find(finding_kinds(), written.code, &FindingKind::code) == finding_kinds().end())
        scope.diagnostics.add(messages::unknown_finding(written.where, written.code));
    scope.chart.accepted.push_back({written.code, written.subject, written.reason, written.where});
}

void resolve_acceptances(ChartScope& scope, const tree::Chart& written, const WrittenChart& all) {
    Subjects subjects;
    for (const tree::ChartItem& item : written.items) {
        const auto* accept = std::get_if<tree::Accept>(&item);
        if (accept == nullptr) continue;
        if (subjects.empty()) subjects = subjects_of(scope, all);
        record_subject(scope, *accept, subjects);
        resolve_acceptance(scope, *accept);
    }
}

void resolve_items(ChartScope& scope, const tree::Chart& written) {
    for (const tree::ChartItem& item : written.items)
        if (const auto* variables = std::get_if<tree::Variables>(&item)) resolve_variables(scope, *variables);
    const WrittenChart all = declare_steps(scope, written);
    check_step_like(scope);
    check_ports(scope, written.items);
    if (all.steps.empty()) scope.diagnostics.add(messages::empty_chart(written.name.where, scope.chart.name));
    resolve_owners(scope, all);
    resolve_actions(scope, all);
    resolve_transitions(scope, all);
    for (const tree::ChartItem& item : written.items) {
        const auto* constraint = std::get_if<tree::Constraint>(&item);
        if (constraint == nullptr) continue;
        const InChartCopy copy(scope, constraint->copy);
        const Id<Expr> condition = resolve_condition(scope, constraint->condition, {}, "a constraint");
        if (condition.valid() && reads_inputs_only(scope, condition, constraint->where))
            scope.chart.constraints.push_back({condition, constraint->where});
    }
    resolve_acceptances(scope, written, all);
}

/// Returns the position of the declaration of `name`, if `name` is a variable, a step variable, a partial chart or the
/// chart; otherwise empty.
std::optional<Span> declared_name(const ChartScope& scope, std::string_view name) {
    const auto origin_in = [&](const auto& table) {
        const auto found = std::ranges::find(table, name, [](const auto& each) { return std::string_view(each.name); });
        return found == table.end() ? std::nullopt : std::optional(found->origin);
    };
    if (const auto variable = origin_in(scope.chart.variables)) return variable;
    if (const auto partial = origin_in(scope.chart.partial_charts)) return partial;
    const auto steps = name[0] == 'X' ? scope.steps_by_name.find(name.substr(1)) : scope.steps_by_name.end();
    if (steps == scope.steps_by_name.end())
        return name == scope.chart.name ? std::optional(scope.chart.origin) : std::nullopt;
    return scope.chart.steps[steps->second.front()].origin;
}

/// Returns the position of the constant `name` of a chart; empty if the chart has no such constant.
std::optional<Span> constant_named(const tree::File& file, const tree::Chart& written, std::string_view name) {
    for (const tree::Variables& group : written.parameters)
        for (const tree::Variable& each : group.variables)
            if (group.kind == tree::VariableKind::Constant && file.text(each.name) == name) return each.name.where;
    return {};
}

/// Reports each constant that has the name of another declaration.
void check_constants(ChartScope& scope, const tree::File& file, const tree::Chart& written) {
    for (const tree::Variables& group : written.parameters)
        for (const tree::Variable& each : group.variables)
            if (const auto other = declared_name(scope, file.text(each.name));
                group.kind == tree::VariableKind::Constant && other)
                scope.diagnostics.add(messages::duplicate_name(each.name.where, "name", file.text(each.name), *other));
}

}  // namespace

bool has_instances(const std::vector<tree::ChartItem>& items) {
    return std::ranges::any_of(items, [](const tree::ChartItem& item) {
        if (const auto* copies = std::get_if<tree::ReplicatedChartItems>(&item)) return has_instances(copies->items);
        const auto* partial = std::get_if<tree::Partial>(&item);
        return partial != nullptr && partial->chart.valid();
    });
}

std::optional<Chart> resolve_chart(const tree::File& file, const tree::Chart& written, Diagnostics& diagnostics,
                                   Recorder record, std::uint64_t* copied, const WrittenCharts* charts,
                                   ChartInstance* instance) {
    const std::size_t errors = diagnostics.errors();
    tree::File copies;
    ChartScope scope{written.replicated || instance != nullptr ? copies : file, diagnostics, record};
    scope.chart.name = instance == nullptr ? file.text(written.name) : instance->name;
    scope.chart.origin = instance == nullptr ? written.name.where : instance->where;
    if (instance == nullptr)
        record.declare(DeclarationKind::Chart, scope.chart.name, written.name.where, written.where);
    else scope.chart.instance_of = file.text(written.name);
    scope.chart.has_parameters = !written.parameters.empty();
    Expansion expansion{file, copies, diagnostics, record, scope.chart.origin};
    expansion.copied = copied;
    expansion.charts = charts;
    expansion.instance = instance;
    expansion.constant_terms = [&](std::string_view user) { return constant_terms(scope, user); };
    resolve_expanded(expansion, written, [&](const tree::Chart& all) { resolve_items(scope, all); });
    if (instance == nullptr) {
        check_indices(expansion, [&](std::string_view name) {
            const auto constant = constant_named(file, written, name);
            return constant ? constant : declared_name(scope, name);
        });
        check_constants(scope, file, written);
    } else scope.chart.has_defaults = instance->has_defaults;
    if (expansion.incomplete && !record.beyond_errors()) return {};
    if (record.beyond_errors()) return std::move(scope.chart);
    if (diagnostics.errors() != errors) return {};
    check_reachability(scope.chart, diagnostics);
    if (diagnostics.errors() != errors) return {};
    return std::move(scope.chart);
}

}  // namespace grafverif
