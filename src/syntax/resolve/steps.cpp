// SPDX-License-Identifier: MIT
// Resolves the steps and partial charts of a chart, and determines the owner of each partial chart: a macro-step or an
// enclosing step.
#include <algorithm>

#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/resolve/chart_scope.hpp"
#include "syntax/resolve/expand.hpp"

namespace grafverif {

namespace {

Chart::StepKind kind_of(tree::StepKind kind) {
    switch (kind) {
    case tree::StepKind::Ordinary: return Chart::StepKind::Ordinary;
    case tree::StepKind::Macro: return Chart::StepKind::Macro;
    case tree::StepKind::Enclosing: return Chart::StepKind::Enclosing;
    }
    unreachable();
}

Id<Chart::PartialChart> add_partial(ChartScope& scope, std::string_view name, Chart::PartialKind kind, Span where) {
    scope.steps.emplace_back();
    return scope.chart.partial_charts.add({std::string(name), kind, {}, where});
}

void declare_step(ChartScope& scope, const tree::Step& written, Id<Chart::PartialChart> partial, WrittenChart& all) {
    const InChartCopy copy(scope, written.name);
    scope.record.declare(DeclarationKind::Step, scope.text(written.name), written.name.where, written.where,
                         scope.chart.partial_charts[partial].origin);
    const auto [known, fresh] = scope.steps[partial.index].try_emplace(written.name.word);
    if (!fresh) {
        scope.diagnostics.add(
            duplicate(written.name, "step", scope.text(written.name), scope.chart.steps[known->second].origin));
        if (scope.record.beyond_errors()) all.steps.push_back({&written, known->second});
        return;
    }
    Chart::Step step;
    step.name = scope.text(written.name);
    step.kind = kind_of(written.kind);
    step.initial = written.initial;
    step.activation_link = written.linked;
    step.entry = written.entry;
    step.exit = written.exit;
    step.chart = partial;
    step.origin = written.name.where;
    known->second = scope.chart.steps.add(std::move(step));
    scope.steps_by_name[scope.text(written.name)].push_back(known->second);
    all.steps.push_back({&written, known->second});
}

void declare_items(ChartScope& scope, const std::vector<tree::ChartItem>& items, Id<Chart::PartialChart> partial,
                   WrittenChart& all);

void declare_partial(ChartScope& scope, const tree::Partial& written, WrittenChart& all) {
    const InChartCopy copy(scope, written.name);
    const bool expansion = written.kind == tree::PartialKind::Expansion;
    scope.record.declare(DeclarationKind::Partial, scope.text(written.name), written.name.where, written.where,
                         scope.chart.origin);
    const auto [known, fresh] = scope.partials.try_emplace(written.name.word);
    if (!fresh) {
        scope.diagnostics.add(duplicate(written.name, "partial chart", scope.text(written.name),
                                        scope.chart.partial_charts[known->second].origin));
        if (scope.record.beyond_errors()) declare_items(scope, written.items, known->second, all);
        return;
    }
    known->second =
        add_partial(scope, scope.text(written.name),
                    expansion ? Chart::PartialKind::Expansion : Chart::PartialKind::Plain, written.name.where);
    declare_items(scope, written.items, known->second, all);
}

void declare_items(ChartScope& scope, const std::vector<tree::ChartItem>& items, Id<Chart::PartialChart> partial,
                   WrittenChart& all) {
    for (const tree::ChartItem& item : items) {
        std::visit(overloaded{
                       [](const tree::Variables&) {}, [](const tree::Constraint&) {}, [](const tree::Accept&) {},
                       [&](const tree::Step& step) { declare_step(scope, step, partial, all); },
                       [&](const tree::Transition& transition) {
                           all.transitions.push_back({&transition, partial});
                       },
                       [&](const tree::Partial& inner) { declare_partial(scope, inner, all); },
                       [](const tree::ReplicatedChartItems&) {},  // already expanded
                   },
                   item);
    }
}

bool is_direct(const tree::ChartItem& item) {
    return std::holds_alternative<tree::Step>(item) || std::holds_alternative<tree::Transition>(item);
}

void own(ChartScope& scope, Id<Chart::PartialChart> partial, Id<Chart::Step> step, Span where) {
    Chart::PartialChart& owned = scope.chart.partial_charts[partial];
    if (owned.owner.valid()) {
        scope.diagnostics.add(messages::owned_twice(where, owned.name, scope.chart.steps[owned.owner].origin));
        return;
    }
    owned.owner = step;
}

void resolve_contents(ChartScope& scope, const WrittenStep& written) {
    const InChartCopy copy(scope, written.step->name);
    for (const tree::Name& name : written.step->contents) {
        const Id<Chart::PartialChart> partial = partial_named(scope, name);
        if (!partial.valid()) continue;
        const bool expansion = scope.chart.partial_charts[partial].kind == Chart::PartialKind::Expansion;
        if (written.step->kind == tree::StepKind::Macro && !expansion) {
            scope.diagnostics.add(messages::not_an_expansion(name.where, scope.text(name)));
            continue;
        }
        if (written.step->kind == tree::StepKind::Enclosing) {
            if (expansion) {
                scope.diagnostics.add(
                    messages::misplaced_mark(name.where, "encloses", "a step that encloses partial charts"));
                continue;
            }
            scope.chart.partial_charts[partial].kind = Chart::PartialKind::Enclosed;
        }
        own(scope, partial, written.id, name.where);
    }
}

/// Reports the keywords `entry`, `exit` and `linked` at steps for which they have no meaning.
void check_marks(ChartScope& scope, const WrittenStep& written) {
    const Chart::Step& step = scope.chart.steps[written.id];
    const Chart::PartialKind kind = scope.chart.partial_charts[step.chart].kind;
    if (step.entry && kind != Chart::PartialKind::Expansion)
        scope.diagnostics.add(messages::misplaced_mark(step.origin, "entry", "an `expansion`"));
    if (step.exit && kind != Chart::PartialKind::Expansion)
        scope.diagnostics.add(messages::misplaced_mark(step.origin, "exit", "an `expansion`"));
    if (step.activation_link && kind != Chart::PartialKind::Enclosed)
        scope.diagnostics.add(messages::misplaced_mark(step.origin, "linked", "an enclosed partial chart"));
}

void check_expansions(ChartScope& scope) {
    std::vector<std::size_t> entries(scope.chart.partial_charts.size()), exits(entries.size());
    for (const Chart::Step& step : scope.chart.steps) {
        entries[step.chart.index] += step.entry ? 1 : 0;
        exits[step.chart.index] += step.exit ? 1 : 0;
    }
    for (const Id<Chart::PartialChart> id : scope.chart.partial_charts.ids()) {
        const Chart::PartialChart& partial = scope.chart.partial_charts[id];
        if (partial.kind != Chart::PartialKind::Expansion) continue;
        if (entries[id.index] != 1 || exits[id.index] != 1)
            scope.diagnostics.add(messages::entry_and_exit(partial.origin, partial.name));
        if (!partial.owner.valid()) scope.diagnostics.add(messages::unused_expansion(partial.origin, partial.name));
    }
}

}  // namespace

WrittenChart declare_steps(ChartScope& scope, const tree::Chart& written) {
    WrittenChart all;
    Id<Chart::PartialChart> unnamed;
    if (std::ranges::any_of(written.items, is_direct))
        unnamed = add_partial(scope, "", Chart::PartialKind::Plain, written.name.where);
    declare_items(scope, written.items, unnamed, all);
    return all;
}

void resolve_owners(ChartScope& scope, const WrittenChart& written) {
    for (const WrittenStep& step : written.steps) resolve_contents(scope, step);
    for (const WrittenStep& step : written.steps) check_marks(scope, step);
    check_expansions(scope);
}

}  // namespace grafverif
