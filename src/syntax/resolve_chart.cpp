// SPDX-License-Identifier: MIT
// A chart: its variables first, then its steps, then what names both.
#include "grafverif/support/messages.hpp"
#include "grafverif/syntax/resolve.hpp"
#include "syntax/chart_scope.hpp"

namespace grafverif {

std::optional<Chart> resolve_chart(const tree::File& file, const tree::Chart& written, Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    ChartScope scope{file, diagnostics};
    scope.chart.name = file.text(written.name);
    scope.chart.origin = written.name.where;
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
        if (condition.valid()) scope.chart.constraints.push_back(condition);
    }
    if (diagnostics.errors() != errors) return {};
    check_reachability(scope.chart, diagnostics);
    if (diagnostics.errors() != errors) return {};
    return std::move(scope.chart);
}

}  // namespace grafverif
