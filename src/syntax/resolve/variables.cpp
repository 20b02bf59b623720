// SPDX-License-Identifier: MIT
// Resolves the variables of a chart: inputs, outputs and internal variables.
#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/resolve/chart_scope.hpp"
#include "syntax/resolve/expand.hpp"
#include "syntax/resolve/resolve.hpp"

namespace grafverif {

namespace {

Chart::VariableKind kind_of(tree::VariableKind kind) {
    switch (kind) {
    case tree::VariableKind::Input: return Chart::VariableKind::Input;
    case tree::VariableKind::Output: return Chart::VariableKind::Output;
    case tree::VariableKind::Internal: return Chart::VariableKind::Internal;
    case tree::VariableKind::Own:
    case tree::VariableKind::Constant: break;  // the grammar of charts excludes these types
    }
    unreachable();
}

/// Returns the declared type; Boolean after an error.
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
        const InCopy copy(scope.diagnostics, scope.file, variable.name);
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
