// SPDX-License-Identifier: MIT
// Resolves the variables of a chart: inputs, outputs and internal variables.
#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/resolve/chart_scope.hpp"
#include "syntax/resolve/expand.hpp"
#include "syntax/resolve/nearest.hpp"
#include "syntax/resolve/resolve.hpp"

namespace grafverif {

namespace {

Chart::VariableKind kind_of(tree::VariableKind kind) {
    switch (kind) {
    case tree::VariableKind::Input: return Chart::VariableKind::Input;
    case tree::VariableKind::Output: return Chart::VariableKind::Output;
    case tree::VariableKind::Internal: return Chart::VariableKind::Internal;
    case tree::VariableKind::Own:
    case tree::VariableKind::Constant: break;  // the grammar excludes these types in charts
    }
    unreachable();
}

/// Returns the declared type of a variable; Boolean after an error.
Type type_of(ChartScope& scope, const tree::Variable& written) {
    Terms terms = constant_terms(scope, "a range or value of a declaration");
    switch (written.type) {
    case tree::TypeWord::Bool: return {};
    case tree::TypeWord::Duration:
        scope.diagnostics.add(messages::misplaced_type(
            written.where, "variables of a chart cannot be durations; write time conditions, as in `3s/X2`"));
        return {};
    case tree::TypeWord::None: {
        if (!written.value.valid()) return {};
        const std::size_t errors = scope.diagnostics.errors();
        const Term value = terms.resolve(written.value);
        if (scope.diagnostics.errors() == errors && value.kind == TermKind::Integer)
            scope.diagnostics.add(messages::unbounded_integer(written.where, scope.text(written.name)));
        return {};
    }
    case tree::TypeWord::Int: {
        if (!written.range) {
            scope.diagnostics.add(messages::unbounded_integer(written.where, scope.text(written.name)));
            return {};
        }
        const auto low = terms.constant(written.range->low, TermKind::Integer, "a range");
        const auto high = terms.constant(written.range->high, TermKind::Integer, "a range");
        if (!low || !high) return {};
        if (*low > *high || *low < least_integer || *high > greatest_integer) {
            scope.diagnostics.add(messages::bad_range(written.where, scope.text(written.name), *low, *high));
            return {};
        }
        return integer_type(*low, *high);
    }
    }
    unreachable();
}

std::int64_t initial_of(ChartScope& scope, const tree::Variable& written, tree::VariableKind kind, const Type& type) {
    if (!written.value.valid()) return type.low;
    if (kind != tree::VariableKind::Internal) {
        scope.diagnostics.add(messages::misplaced_value(scope.file.exprs[written.value].where,
                                                        kind == tree::VariableKind::Input ? "input" : "output"));
        return type.low;
    }
    Terms terms = constant_terms(scope, "a range or value of a declaration");
    const auto value =
        terms.constant(written.value, type.boolean ? TermKind::Boolean : TermKind::Integer, "this variable");
    if (!value) return type.low;
    if (*value < type.low || *value > type.high) {
        scope.diagnostics.add(messages::initial_out_of_range(scope.file.exprs[written.value].where,
                                                             scope.text(written.name), *value, type.low, type.high));
        return type.low;
    }
    return *value;
}

}  // namespace

DeclarationKind declaration_kind(Chart::VariableKind kind) {
    switch (kind) {
    case Chart::VariableKind::Input: return DeclarationKind::Input;
    case Chart::VariableKind::Output: return DeclarationKind::Output;
    case Chart::VariableKind::Internal: return DeclarationKind::Internal;
    }
    unreachable();
}

Terms constant_terms(ChartScope& scope, std::string_view user) {
    Terms terms(scope.file, scope.chart.exprs, scope.diagnostics);
    terms.name = [&scope, user = std::string(user)](const tree::Expr& node) {
        scope.diagnostics.add(messages::not_constant(node.where, user));
        return Term{};
    };
    return terms;
}

void resolve_variables(ChartScope& scope, const tree::Variables& written) {
    for (const tree::Variable& variable : written.variables) {
        const InChartCopy copy(scope, variable.name);
        const std::size_t errors = scope.diagnostics.errors();
        Chart::Variable resolved;
        resolved.name = scope.text(variable.name);
        resolved.kind = kind_of(written.kind);
        resolved.type = type_of(scope, variable);
        if (scope.diagnostics.errors() == errors)
            resolved.initial = initial_of(scope, variable, written.kind, resolved.type);
        resolved.origin = variable.name.where;
        scope.record.declare(declaration_kind(resolved.kind), resolved.name, resolved.origin, variable.where,
                             scope.chart.origin);
        const auto [known, fresh] = scope.variables.try_emplace(variable.name.word);
        if (!fresh) {
            scope.diagnostics.add(
                duplicate(variable.name, "variable", resolved.name, scope.chart.variables[known->second].origin));
            continue;
        }
        known->second = scope.chart.variables.add(std::move(resolved));
    }
    scope.continuous.resize(scope.chart.variables.size());
    scope.stored.resize(scope.chart.variables.size());
}

namespace {

/// Reports that the variable that is bound to a port is unknown. Declares the variable, so that terms that read it
/// cause no further errors.
void report_unknown(ChartScope& scope, tree::VariableKind kind, const tree::Variable& port) {
    const std::string_view name = scope.text(port.name);
    const auto steps = name[0] == 'X' ? scope.steps_by_name.find(name.substr(1)) : scope.steps_by_name.end();
    std::string meant;
    if (steps != scope.steps_by_name.end()) {
        const Id<Chart::PartialChart> partial = scope.chart.steps[steps->second.front()].chart;
        const std::string& owner = scope.chart.partial_charts[partial].name;
        meant = (owner.empty() ? scope.chart.name : owner) + '.' + std::string(name);
    } else if (!scope.diagnostics.full()) {
        Nearest nearest(name);
        for (const Chart::Variable& variable : scope.chart.variables) nearest.offer(variable.name);
        meant = nearest.best();
    }
    scope.diagnostics.add(messages::unknown(port.name.where, "variable", name, meant));
    Chart::Variable missing;
    missing.name = name;
    missing.kind = kind_of(kind);
    missing.type = type_of(scope, port);
    missing.origin = port.name.where;
    scope.variables.emplace(port.name.word, scope.chart.variables.add(std::move(missing)));
    scope.continuous.resize(scope.chart.variables.size());
    scope.stored.resize(scope.chart.variables.size());
}

void check_port(ChartScope& scope, tree::VariableKind kind, const tree::Variable& port) {
    const Span where = port.name.where;
    const bool writes = kind == tree::VariableKind::Output;
    if (port.value.valid()) {  // a step variable is bound to the port
        if (writes) return scope.diagnostics.add(messages::output_not_a_name(where, scope.text(port.name)));
        terms_of(scope).resolve(port.value, TermKind::Boolean, "a port");
        if (port.type == tree::TypeWord::Int)
            scope.diagnostics.add(messages::argument_type(where, scope.text(port.name), "Boolean", "an integer"));
        return;
    }
    const auto found = scope.variables.find(port.name.word);
    if (found == scope.variables.end()) return report_unknown(scope, kind, port);
    const Chart::Variable& variable = scope.chart.variables[found->second];
    scope.record.refer(where, variable.origin, writes);
    Type type;
    {
        const InChartCopy copy(scope, port.name);
        type = type_of(scope, port);
    }
    const auto described = [](bool boolean) { return boolean ? "Boolean" : "an integer"; };
    if (writes && variable.kind == Chart::VariableKind::Input)
        return scope.diagnostics.add(messages::assigned_input(where, variable.name));
    if (type.boolean != variable.type.boolean)
        return scope.diagnostics.add(
            messages::argument_type(where, variable.name, described(variable.type.boolean), described(type.boolean)));
    const Type& from = writes ? type : variable.type;
    const Type& to = writes ? variable.type : type;
    if (from.low < to.low || from.high > to.high)
        scope.diagnostics.add(messages::range_mismatch(where, variable.name, from.low, from.high, to.low, to.high));
}

}  // namespace

void check_ports(ChartScope& scope, const std::vector<tree::ChartItem>& items) {
    for (const tree::ChartItem& item : items)
        if (const auto* partial = std::get_if<tree::Partial>(&item))
            for (const tree::Variables& group : partial->ports)
                for (const tree::Variable& port : group.variables) check_port(scope, group.kind, port);
}

void check_step_like(ChartScope& scope) {
    for (const Chart::Variable& variable : scope.chart.variables) {
        const std::string_view name = variable.name;
        if (name.size() < 2 || name[0] != 'X') continue;
        const bool numbered = name[1] >= '0' && name[1] <= '9';
        if (numbered || scope.steps_by_name.contains(name.substr(1)))
            scope.diagnostics.add(messages::step_like_variable(variable.origin, name));
    }
}

}  // namespace grafverif
