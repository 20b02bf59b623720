// SPDX-License-Identifier: MIT
// Resolves the named constants of a closed loop. The value of a constant may depend on earlier constants, and the user
// can override it. Terms contain the value instead of the name, so that constants do not exist in later stages.
#include "syntax/print/constants.hpp"

#include <string>
#include <vector>

#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/resolve/loop_scope.hpp"

namespace grafverif {

namespace {

using Named = NamedConstant;

TermKind kind_of(Named::Kind kind) {
    switch (kind) {
    case Named::Kind::Boolean: return TermKind::Boolean;
    case Named::Kind::Integer: return TermKind::Integer;
    case Named::Kind::Duration: return TermKind::Duration;
    }
    unreachable();
}

/// Returns the declared type, or the type of the value if none is declared, or nothing after an error.
std::optional<Named::Kind> written_kind(const tree::Variable& written, TermKind value) {
    switch (written.type) {
    case tree::TypeWord::Bool: return Named::Kind::Boolean;
    case tree::TypeWord::Int: return Named::Kind::Integer;
    case tree::TypeWord::Duration: return Named::Kind::Duration;
    case tree::TypeWord::None: break;
    }
    if (value == TermKind::Boolean) return Named::Kind::Boolean;
    if (value == TermKind::Integer) return Named::Kind::Integer;
    if (value == TermKind::Duration) return Named::Kind::Duration;
    return {};
}

struct Bounds {
    std::int64_t low = 0, high = 0;
    bool contain(std::int64_t value) const { return low <= value && value <= high; }
};

/// Returns the declared range, or nothing if there is none or after an error.
std::optional<Bounds> bounds_of(LoopScope& scope, const tree::Variable& written) {
    if (!written.range) return {};
    Terms terms = constant_terms(scope, "a range");
    const auto low = terms.constant(written.range->low, TermKind::Integer, "a range");
    const auto high = terms.constant(written.range->high, TermKind::Integer, "a range");
    if (!low || !high) return {};
    if (*low <= *high) return Bounds{*low, *high};
    scope.diagnostics.add(messages::bad_range(written.where, scope.text(written.name), *low, *high));
    return {};
}

/// Replaces the declared value by the value that the user has set.
void set_from_outside(LoopScope& scope, const std::optional<Bounds>& bounds, Named& constant) {
    const auto given = scope.context.constants.find(constant.name);
    if (given == scope.context.constants.end()) return;
    constant.set = true;
    const auto value = value_of(constant.kind, given->second);
    if (!value) {
        scope.diagnostics.add(
            messages::bad_setting(constant.origin, constant.name, given->second, described(kind_of(constant.kind))));
        return;
    }
    constant.value = *value;
    if (bounds && !bounds->contain(*value))
        scope.diagnostics.add(
            messages::setting_out_of_range(constant.origin, constant.name, given->second, bounds->low, bounds->high));
}

void declare_constant(LoopScope& scope, const tree::Variable& written) {
    Named constant{.name = std::string(scope.text(written.name)), .origin = written.name.where};
    if (!written.value.valid()) {
        scope.diagnostics.add(messages::constant_without_value(written.where, constant.name));
        return;
    }
    const std::size_t errors = scope.diagnostics.errors();
    const std::string user = '`' + constant.name + '`';
    const Term term = constant_terms(scope, user).resolve(written.value);
    const auto kind = written_kind(written, term.kind);
    auto bounds = bounds_of(scope, written);
    if (!kind || scope.diagnostics.errors() != errors) return;
    constant.kind = *kind;
    if (*kind == Named::Kind::Integer) {  // the limits of variables also apply to constants
        if (!bounds) bounds = {least_integer, greatest_integer};
        bounds = {std::max(bounds->low, least_integer), std::min(bounds->high, greatest_integer)};
    }
    const auto value = constant_terms(scope, user).constant(written.value, kind_of(*kind), user);
    if (!value) return;
    constant.value = *value;
    if (bounds && !bounds->contain(*value))
        scope.diagnostics.add(messages::initial_out_of_range(scope.file.exprs[written.value].where, constant.name,
                                                             *value, bounds->low, bounds->high));
    set_from_outside(scope, bounds, constant);
    for (const Named& known : scope.loop.constants)
        if (known.name == constant.name)
            scope.diagnostics.add(
                messages::duplicate_name(written.name.where, "constant", constant.name, known.origin));
    scope.loop.constants.push_back(std::move(constant));
}

}  // namespace

void resolve_constants(LoopScope& scope, const tree::ClosedLoop& written) {
    std::vector<const tree::Variable*> all;
    for (const tree::LoopItem& item : written.items)
        if (const auto* group = std::get_if<tree::Variables>(&item))
            for (const tree::Variable& variable : group->variables) {
                all.push_back(&variable);
                scope.below.insert(scope.text(variable.name));
                scope.constants.emplace(scope.text(variable.name), variable.name.where);
                scope.record.declare(DeclarationKind::Constant, scope.text(variable.name), variable.name.where,
                                     variable.where, scope.loop.origin);
            }
    for (const tree::Variable* variable : all) {
        const std::size_t errors = scope.diagnostics.errors();
        declare_constant(scope, *variable);
        scope.below.erase(scope.text(variable->name));
        if (scope.diagnostics.errors() == errors) continue;
        scope.excused.insert(scope.text(variable->name));
        scope.valueless.insert(scope.text(variable->name));
    }
}

void check_constant_names(LoopScope& scope) {
    for (const Named& constant : scope.loop.constants) {
        const std::string_view name = constant.name;
        const auto clash = [&](Span first) {
            scope.diagnostics.add(messages::duplicate_name(constant.origin, "name", name, first));
        };
        if (const auto shared = scope.shared.find(constant.name); shared != scope.shared.end())
            clash(scope.loop.shared[shared->second].origin);
        for (const Id<ClosedLoop::Controller> id : scope.loop.controllers.ids()) {
            const LoopScope::Inside& inside = scope.inside[id.index];
            const auto internal = inside.internals.find(name);
            if (internal != inside.internals.end()) clash(scope.chart(id).variables[internal->second].origin);
            const auto steps =
                name.size() > 1 && name[0] == 'X' ? inside.steps.find(name.substr(1)) : inside.steps.end();
            if (steps != inside.steps.end()) clash(scope.chart(id).steps[steps->second.front()].origin);
        }
    }
}

std::optional<Term> constant_named(LoopScope& scope, std::string_view name, Span where) {
    const auto known = scope.constants.find(name);
    if (known == scope.constants.end()) return {};
    scope.record.refer(where, known->second);
    for (const Named& constant : scope.loop.constants) {
        if (constant.name != name) continue;
        Exprs& exprs = scope.loop.exprs;
        switch (constant.kind) {
        case Named::Kind::Boolean: return Term{exprs.constant(constant.value != 0), TermKind::Boolean};
        case Named::Kind::Integer: return Term{exprs.integer(constant.value), TermKind::Integer};
        case Named::Kind::Duration: return Term{exprs.duration(constant.value), TermKind::Duration};
        }
    }
    return {};
}

Terms constant_terms(LoopScope& scope, std::string_view user) {
    Terms terms(scope.file, scope.loop.exprs, scope.diagnostics);
    terms.name = [&scope, user = std::string(user)](const tree::Expr& node) {
        const bool simple = node.op == tree::Op::Name;
        const std::string_view name = scope.file.text(node.word);
        if (simple)
            if (const auto constant = constant_named(scope, name, node.where)) return *constant;
        if (simple && scope.valueless.contains(name)) return Term{};
        if (simple && scope.below.contains(name)) scope.diagnostics.add(messages::constant_below(node.where, name));
        else scope.diagnostics.add(messages::not_constant(node.where, user));
        return Term{};
    };
    return terms;
}

}  // namespace grafverif
