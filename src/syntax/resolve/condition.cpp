// SPDX-License-Identifier: MIT
// Resolves the names in the conditions of a chart (variables and step variables, IEC 60848) and the time conditions.
#include <array>
#include <string>

#include "support/messages.hpp"
#include "support/messages_notation.hpp"
#include "syntax/resolve/chart_scope.hpp"
#include "syntax/resolve/nearest.hpp"

namespace grafverif {

namespace {

// -- names -----------------------------------------------------------------------------------------------------------

Term step_term(ChartScope& scope, Id<Chart::Step> step) {
    return {scope.chart.exprs.leaf(Op::Step, step.index), TermKind::Boolean};
}

Term unknown_name(ChartScope& scope, Span where, std::string_view name) {
    const bool step_like = name.size() > 1 && name[0] == 'X' && name[1] >= '0' && name[1] <= '9';
    if (scope.diagnostics.full())
        return scope.diagnostics.add(messages::unknown(where, step_like ? "step" : "variable", name, "")), Term{};
    Nearest nearest(name);
    // For a name in an instance of a chart, such as `Head.N`, no variable is suggested.
    const bool in_instance = name.find('.') != std::string_view::npos;
    if (!step_like && !in_instance)
        for (const Chart::Variable& variable : scope.chart.variables) nearest.offer(variable.name);
    if (name[0] == 'X' || name[0] == 'x')
        for (const Chart::Step& step : scope.chart.steps) nearest.offer('X', step.name);
    scope.diagnostics.add(messages::unknown(where, step_like ? "step" : "variable", name, nearest.best()));
    return {};
}

/// Resolves a step variable such as `X2` in the current partial chart or, if the name is unique, in the complete chart.
Term step_variable_term(ChartScope& scope, Span where, std::string_view name) {
    if (name.size() < 2 || name[0] != 'X') return unknown_name(scope, where, name);
    const auto found = scope.steps_by_name.find(name.substr(1));
    if (found == scope.steps_by_name.end()) return unknown_name(scope, where, name);
    for (const Id<Chart::Step> step : found->second)
        if (scope.chart.steps[step].chart == scope.here) return step_term(scope, step);
    if (found->second.size() > 1) {
        scope.diagnostics.add(messages::ambiguous(where, name, step_variable(scope.chart, found->second[0]),
                                                  step_variable(scope.chart, found->second[1])));
        return {};
    }
    return step_term(scope, found->second.front());
}

Term variable_term(ChartScope& scope, Id<Chart::Variable> variable) {
    const bool boolean = scope.chart.variables[variable].type.boolean;
    return {scope.chart.exprs.leaf(Op::Variable, variable.index), boolean ? TermKind::Boolean : TermKind::Integer};
}

Term name_term(ChartScope& scope, const tree::Expr& node) {
    const std::uint64_t key = (static_cast<std::uint64_t>(scope.here.index) << 32U) | node.word.index;
    const auto known = scope.known_names.find(key);
    if (known != scope.known_names.end()) return known->second;
    const auto variable = scope.variables.find(node.word);
    const Term term = variable != scope.variables.end()
                          ? variable_term(scope, variable->second)
                          : step_variable_term(scope, node.where, scope.file.text(node.word));
    if (term.kind != TermKind::Wrong) scope.known_names.emplace(key, term);
    return term;
}

/// Reports terms of IEC 61131-3 such as `Fill.T`, `X2.T` and `Fill.X` if `Fill` and `2` are steps.
bool report_step_member(ChartScope& scope, const tree::Expr& node) {
    const std::string_view owner = scope.text({scope.file.exprs[node.first].word, {}}),
                           member = scope.file.text(node.word);
    const bool is_variable = owner.starts_with('X') && scope.steps_by_name.contains(owner.substr(1));
    if (!is_step_member(member) || !(is_variable || scope.steps_by_name.contains(owner))) return false;
    scope.diagnostics.add(
        messages::step_member(node.where, is_variable ? std::string(owner) : 'X' + std::string(owner), member));
    return true;
}

/// Resolves a qualified name such as `G2.X2`. The name of the chart qualifies the steps that are declared directly in
/// the chart.
Term member_term(ChartScope& scope, const tree::Expr& node) {
    const tree::Expr& owner = scope.file.exprs[node.first];
    const std::string_view name = scope.file.text(node.word);
    if (owner.op != tree::Op::Name) {
        scope.diagnostics.add(messages::unknown(owner.where, "partial chart", "...", ""));
        return {};
    }
    Id<Chart::PartialChart> partial;
    if (scope.partials.contains(owner.word)) partial = partial_named(scope, {owner.word, owner.where});
    else if (report_step_member(scope, node)) return {};
    else if (scope.file.text(owner.word) ==
             (scope.chart.instance_of.empty() ? scope.chart.name : scope.chart.instance_of)) {
        partial = Id<Chart::PartialChart>{0};
        scope.record.refer(owner.where, scope.chart.origin);
    } else partial = partial_named(scope, {owner.word, owner.where});
    if (!partial.valid()) return {};
    const auto found =
        name.size() > 1 && name[0] == 'X' ? scope.steps_by_name.find(name.substr(1)) : scope.steps_by_name.end();
    if (found != scope.steps_by_name.end())
        for (const Id<Chart::Step> step : found->second)
            if (scope.chart.steps[step].chart == partial) return step_term(scope, step);
    Nearest nearest(name);
    if (!scope.diagnostics.full())
        for (const Chart::Step& step : scope.chart.steps)
            if (step.chart == partial) nearest.offer('X', step.name);
    scope.diagnostics.add(messages::unknown(node.where, "step", name, nearest.best()));
    return {};
}

/// Records the variable or step that a name denotes.
void record_leaf(ChartScope& scope, const tree::Expr& node, const Term& term) {
    if (term.kind == TermKind::Wrong) return;
    const Expr& leaf = scope.chart.exprs[term.expr];
    const auto index = static_cast<std::uint32_t>(leaf.value);
    scope.record.refer(last_name(node.where, scope.file.text(node.word)),
                       leaf.op == Op::Step ? scope.chart.steps[{index}].origin : scope.chart.variables[{index}].origin);
}

// -- time ------------------------------------------------------------------------------------------------------------

Term time_term(ChartScope& scope, const tree::Expr& node, const WrittenTime& written) {
    Terms terms = terms_of(scope);
    const Id<Expr> watched = terms.resolve(written.watched, TermKind::Boolean, "a time condition");
    const Chart::TimeCondition time{milliseconds(scope.file, written.rise, scope.diagnostics), watched,
                                    milliseconds(scope.file, written.fall, scope.diagnostics), node.where};
    if (!watched.valid()) return {};
    const std::string key =
        std::to_string(time.rise_ms) + '/' + std::to_string(watched.index) + '/' + std::to_string(time.fall_ms);
    const auto [known, fresh] = scope.times.try_emplace(key);
    if (fresh) known->second = scope.chart.time_conditions.add(time);
    return {scope.chart.exprs.leaf(Op::Timed, known->second.index), TermKind::Boolean};
}

/// Detects a time condition without unit, such as `3/X2`: if a number is divided by a name, returns the type of the
/// name; otherwise returns Integer.
TermKind timed_without_unit(ChartScope& scope, const tree::Expr& node) {
    const tree::Expr& left = scope.file.exprs[node.first];
    const tree::Expr& right = scope.file.exprs[node.last];
    if (left.op != tree::Op::Number || (right.op != tree::Op::Name && right.op != tree::Op::Member))
        return TermKind::Integer;
    return terms_of(scope).resolve(node.last).kind;
}

std::optional<Term> special_term(ChartScope& scope, const tree::Expr& node) {
    if (node.op != tree::Op::Divide) return {};
    const WrittenTime time = written_time(scope.file, node);
    if (time.watched.valid()) return time_term(scope, node, time);
    const TermKind divisor = timed_without_unit(scope, node);
    if (divisor != TermKind::Boolean && divisor != TermKind::Wrong) return {};
    if (divisor == TermKind::Boolean)
        scope.diagnostics.add(messages::missing_unit(scope.file.exprs[node.first].where, "this time"));
    return Term{};
}

}  // namespace

Terms terms_of(ChartScope& scope) {
    Terms terms(scope.file, scope.chart.exprs, scope.diagnostics);
    terms.edges_allowed = true;
    terms.name = [&scope](const tree::Expr& node) {
        const Term term = node.op == tree::Op::Name ? name_term(scope, node) : member_term(scope, node);
        record_leaf(scope, node, term);
        return term;
    };
    terms.special = [&scope](const tree::Expr& node) { return special_term(scope, node); };
    return terms;
}

Id<Expr> resolve_condition(ChartScope& scope, Id<tree::Expr> node, Id<Chart::PartialChart> here,
                           std::string_view user) {
    scope.here = here;
    return terms_of(scope).resolve(node, TermKind::Boolean, user);
}

Id<Chart::Step> step_in(ChartScope& scope, Id<Chart::PartialChart> here, tree::Name label) {
    const auto found = scope.steps[here.index].find(label.word);
    if (found != scope.steps[here.index].end())
        return scope.record.refer(label.where, scope.chart.steps[found->second].origin), found->second;
    const std::string_view name = scope.text(label);
    if (scope.diagnostics.full())
        return scope.diagnostics.add(messages::unknown(label.where, "step", name, "")), Id<Chart::Step>{};
    const auto elsewhere = scope.steps_by_name.find(name);
    if (elsewhere != scope.steps_by_name.end()) {
        const Id<Chart::PartialChart> partial = scope.chart.steps[elsewhere->second.front()].chart;
        scope.record.refer(label.where, scope.chart.steps[elsewhere->second.front()].origin);
        scope.diagnostics.add(
            messages::step_of_other_chart(label.where, name, scope.chart.partial_charts[partial].name));
        return {};
    }
    Nearest nearest(name);
    for (const auto& step : scope.chart.steps)
        if (step.chart == here) nearest.offer(step.name);
    const bool as_variable = name.size() > 1 && name[0] == 'X' && scope.steps_by_name.contains(name.substr(1));
    scope.diagnostics.add(messages::unknown(label.where, "step", name, as_variable ? name.substr(1) : nearest.best()));
    return {};
}

Id<Chart::PartialChart> partial_named(ChartScope& scope, tree::Name name) {
    const auto found = scope.partials.find(name.word);
    if (found != scope.partials.end())
        return scope.record.refer(name.where, scope.chart.partial_charts[found->second].origin), found->second;
    if (scope.diagnostics.full())
        return scope.diagnostics.add(messages::unknown(name.where, "partial chart", scope.text(name), "")),
               Id<Chart::PartialChart>{};
    Nearest nearest(scope.text(name));
    for (const Chart::PartialChart& partial : scope.chart.partial_charts)
        if (!partial.name.empty()) nearest.offer(partial.name);
    scope.diagnostics.add(messages::unknown(name.where, "partial chart", scope.text(name), nearest.best()));
    return {};
}

}  // namespace grafverif
