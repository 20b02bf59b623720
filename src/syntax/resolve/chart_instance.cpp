// SPDX-License-Identifier: MIT
// Resolves declarations of constants, arguments of chart instances, and controllers that are chart instances.
#include "syntax/resolve/chart_instance.hpp"

#include <algorithm>

#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/resolve/loop_scope.hpp"
#include "syntax/resolve/nearest.hpp"
#include "syntax/resolve/resolve.hpp"

namespace grafverif {

const WrittenCharts::Entry* WrittenCharts::find(const tree::File& file, tree::Name name,
                                                Diagnostics& diagnostics) const {
    const std::string text(file.text(name));
    const auto found = charts.find(text);
    if (in_error.contains(text)) return nullptr;
    if (found != charts.end()) return &found->second;
    std::vector<std::string_view> names;
    if (!diagnostics.full())
        for (const auto& [known, chart] : charts) names.push_back(known);
    std::ranges::sort(names);
    Nearest nearest(text);
    for (const std::string_view known : names) nearest.offer(known);
    diagnostics.add(messages::unknown(name.where, "chart", text, nearest.best()));
    return nullptr;
}

// -- arguments --------------------------------------------------------------------------------------------------------

namespace {

/// Returns the names of the constants of a chart, without indices.
std::unordered_set<std::string_view> constants_of(const WrittenCharts::Entry& chart) {
    std::unordered_set<std::string_view> constants;
    for (const tree::Variables& group : chart.chart->parameters)
        if (group.kind == tree::VariableKind::Constant)
            for (const tree::Variable& each : group.variables) constants.insert(chart.file->text(each.name));
    return constants;
}

/// Resolves the value of a constant. Returns false after an error.
bool read_value(const ArgumentReader& reader, Id<tree::Expr> written, std::string_view name,
                ChartInstance::Argument& argument) {
    const std::string user = '`' + std::string(name) + '`';
    Terms terms = reader.constant_terms(user);
    const TermKind kind = terms.resolve(written).kind;
    if (kind == TermKind::Wrong) return false;
    const auto value = terms.constant(written, kind, user);
    if (!value) return false;
    argument.kind = kind;
    argument.value = *value;
    return true;
}

/// Resolves the variable that is bound to a port (input or output of the chart). Returns false after an error.
bool read_variable(const ArgumentReader& reader, Id<tree::Expr> written, ChartInstance::Argument& argument) {
    const tree::Expr& value = reader.file.exprs[written];
    if (value.op == tree::Op::Name) return argument.variable = reader.file.text(value.word), true;
    const bool is_member = value.op == tree::Op::Member && reader.file.exprs[value.first].op == tree::Op::Name;
    argument.is_term = !is_member;
    if (!is_member) return true;
    if (reader.variable) {
        const auto variable = reader.variable(value);
        argument.variable = variable.value_or("");
        return variable.has_value();
    }
    argument.term = written;
    argument.variable = std::string(reader.file.text(reader.file.exprs[value.first].word)) + '.' +
                        std::string(reader.file.text(value.word));
    return true;
}

}  // namespace

ChartInstance read_arguments(const ArgumentReader& reader, const std::vector<tree::Argument>& arguments,
                             const WrittenCharts::Entry& chart) {
    ChartInstance instance;
    const std::unordered_set<std::string_view> constants = constants_of(chart);
    std::unordered_map<std::string, std::string> ports;  // maps each bound variable to its port
    for (const tree::Argument& written : arguments) {
        const std::string name(reader.file.text(written.parameter));
        const auto [known, fresh] = instance.arguments.try_emplace(name);
        ChartInstance::Argument& argument = known->second;
        if (!fresh) {
            reader.diagnostics.add(
                messages::duplicate_name(written.parameter.where, "argument", name, argument.parameter));
            instance.wrong = true;
            continue;
        }
        argument.parameter = written.parameter.where;
        argument.where = reader.file.exprs[written.value].where;
        if (constants.contains(without_indices(name))) {
            instance.wrong = !read_value(reader, written.value, name, argument) || instance.wrong;
            continue;
        }
        instance.wrong = !read_variable(reader, written.value, argument) || instance.wrong;
        if (argument.variable.empty()) continue;
        const auto [port, first] = ports.try_emplace(argument.variable, name);
        if (first) continue;
        reader.diagnostics.add(messages::bound_twice(argument.where, argument.variable, port->second, name));
        instance.wrong = true;
    }
    return instance;
}

// -- constants --------------------------------------------------------------------------------------------------------

namespace {

/// Returns the declared type of a constant, or the type of its value if no type is declared.
TermKind written_kind(const tree::Variable& written, TermKind value) {
    switch (written.type) {
    case tree::TypeWord::Bool: return TermKind::Boolean;
    case tree::TypeWord::Int: return TermKind::Integer;
    case tree::TypeWord::Duration: return TermKind::Duration;
    case tree::TypeWord::None: return value;
    }
    unreachable();
}

}  // namespace

std::optional<DeclaredConstant> declared_constant(const tree::File& file, const tree::Variable& written,
                                                  Diagnostics& diagnostics,
                                                  const std::function<Terms(std::string_view)>& constant_terms) {
    const std::string name(file.text(written.name));
    if (!written.value.valid())
        return diagnostics.add(messages::constant_without_value(written.where, name)), std::nullopt;
    const std::size_t errors = diagnostics.errors();
    const std::string user = '`' + name + '`';
    DeclaredConstant constant{.low = least_integer, .high = greatest_integer};  // the limits of integer variables
    constant.kind = written_kind(written, constant_terms(user).resolve(written.value).kind);
    if (written.range) {
        Terms terms = constant_terms("a range");
        const auto low = terms.constant(written.range->low, TermKind::Integer, "a range");
        const auto high = terms.constant(written.range->high, TermKind::Integer, "a range");
        if (low && high && *low > *high) diagnostics.add(messages::bad_range(written.where, name, *low, *high));
        constant.low = std::max(constant.low, low.value_or(constant.low));
        constant.high = std::min(constant.high, high.value_or(constant.high));
    }
    if (diagnostics.errors() != errors) return {};
    const auto value = constant_terms(user).constant(written.value, constant.kind, user);
    if (!value) return {};
    constant.value = *value;
    if (!constant.contains(*value))
        diagnostics.add(
            messages::initial_out_of_range(file.exprs[written.value].where, name, *value, constant.low, constant.high));
    return constant;
}

// -- controllers ------------------------------------------------------------------------------------------------------

namespace {

/// Returns the variable that is bound to a parameter of a component instance. For example, if `FULL[1]` is bound to the
/// parameter HERE of `B[1]`, `node` is `B[1].HERE` and the result is `FULL[1]`.
std::optional<std::string> variable_of_port(LoopScope& scope, const tree::Expr& node) {
    const tree::Expr& owner = scope.file.exprs[node.first];
    const std::string_view port = scope.file.text(node.word);
    const auto found = owner.op == tree::Op::Name ? scope.written_instances.find(scope.file.text(owner.word))
                                                  : scope.written_instances.end();
    if (found == scope.written_instances.end()) {
        Nearest nearest(owner.op == tree::Op::Name ? scope.file.text(owner.word) : "");
        std::vector<std::string_view> names;
        if (!scope.diagnostics.full())
            for (const auto& [name, instance] : scope.written_instances) names.push_back(name);
        std::ranges::sort(names);
        for (const std::string_view name : names) nearest.offer(name);
        scope.diagnostics.add(messages::unknown(owner.where, "instance", scope.file.text(owner.word), nearest.best()));
        return {};
    }
    const tree::Instance& instance = *found->second;
    scope.record.refer(owner.where, instance.name.where);
    const auto argument = std::ranges::find(instance.arguments, port,
                                            [&](const tree::Argument& each) { return scope.text(each.parameter); });
    if (argument != instance.arguments.end()) {
        const tree::Expr& value = scope.file.exprs[argument->value];
        if (value.op == tree::Op::Name) return std::string(scope.file.text(value.word));
        scope.diagnostics.add(messages::port_not_a_variable(node.where, port));
        return {};
    }
    Nearest nearest(port);
    if (!scope.diagnostics.full())
        for (const tree::Argument& each : instance.arguments) nearest.offer(scope.text(each.parameter));
    scope.diagnostics.add(messages::unknown(last_name(node.where, port), "parameter", port, nearest.best()));
    return {};
}

}  // namespace

Id<Chart> instantiate(LoopScope& scope, const tree::Controller& written) {
    const std::string name(scope.text(written.instance));
    scope.record.declare(DeclarationKind::Instance, name, written.instance.where, written.where, scope.loop.origin);
    const WrittenCharts& charts = scope.context.charts;
    const WrittenCharts::Entry* const chart = charts.find(scope.file, written.chart, scope.diagnostics);
    std::optional<ChartInstance> instance;
    if (chart != nullptr && !scope.too_large) {
        scope.record.refer(written.chart.where, chart->chart->name.where);
        instance = read_arguments(
            {scope.file, scope.diagnostics, [&scope](std::string_view user) { return constant_terms(scope, user); },
             [&scope](const tree::Expr& node) { return variable_of_port(scope, node); }},
            written.arguments, *chart);
    }
    std::optional<Chart> resolved;
    if (instance) {
        instance->name = name;
        instance->where = written.instance.where;
        instance->chart_where = written.chart.where;
        instance->record = scope.record;
        resolved = resolve_chart(*chart->file, *chart->chart, scope.diagnostics, scope.record.silent(), scope.copied,
                                 &charts, &*instance);
        scope.too_large = instance->too_large;
    }
    if (resolved) return scope.context.model.charts.add(std::move(*resolved));
    scope.incomplete = !scope.record.beyond_errors();
    return {};
}

}  // namespace grafverif
