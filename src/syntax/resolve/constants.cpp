// SPDX-License-Identifier: MIT
// Resolves the named constants of a closed loop. The value of a constant may depend on earlier constants, and the user
// can override the value. Terms contain the value instead of the name, so that constants do not exist in later stages.
#include "syntax/print/constants.hpp"

#include <string>

#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/resolve/chart_instance.hpp"
#include "syntax/resolve/expand.hpp"
#include "syntax/resolve/loop_scope.hpp"

namespace grafverif {

namespace {

using Named = NamedConstant;

Named::Kind kind_of(TermKind kind) {
    return kind == TermKind::Boolean   ? Named::Kind::Boolean
           : kind == TermKind::Integer ? Named::Kind::Integer
                                       : Named::Kind::Duration;
}

TermKind kind_of(Named::Kind kind) {
    switch (kind) {
    case Named::Kind::Boolean: return TermKind::Boolean;
    case Named::Kind::Integer: return TermKind::Integer;
    case Named::Kind::Duration: return TermKind::Duration;
    }
    unreachable();
}

/// If the user has set a value for the constant (`--set`), replaces the declared value by this value.
void set_from_outside(LoopScope& scope, const DeclaredConstant& declared, Named& constant) {
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
    if (!declared.contains(*value))
        scope.diagnostics.add(
            messages::setting_out_of_range(constant.origin, constant.name, given->second, declared.low, declared.high));
}

void declare_constant(LoopScope& scope, const tree::Variable& written) {
    const auto declared = declared_constant(scope.file, written, scope.diagnostics,
                                            [&](std::string_view user) { return constant_terms(scope, user); });
    if (!declared) return;
    Named constant{.name = std::string(scope.text(written.name)), .origin = written.name.where};
    constant.kind = kind_of(declared->kind);
    constant.value = declared->value;
    set_from_outside(scope, *declared, constant);
    std::optional<std::size_t>& known = scope.constants[constant.name].number;
    if (known)
        scope.diagnostics.add(duplicate(written.name, "constant", constant.name, scope.loop.constants[*known].origin));
    else known = scope.loop.constants.size();
    scope.loop.constants.push_back(std::move(constant));
}

}  // namespace

void announce_constants(LoopScope& scope, const tree::File& file, const tree::ClosedLoop& written) {
    each_item(written.items, [&](const tree::LoopItem& item) {
        if (const auto* group = std::get_if<tree::Variables>(&item))
            for (const tree::Variable& variable : group->variables)
                scope.last_declarations.insert_or_assign(
                    file.text(variable.name), LoopScope::LastDeclaration{variable.name.where, variable.where});
    });
}

void resolve_constants(LoopScope& scope, const tree::Variables& written) {
    for (const tree::Variable& variable : written.variables) {
        const InCopy copy(scope.diagnostics, scope.file, variable.name);
        const std::string name(scope.text(variable.name));
        const std::size_t errors = scope.diagnostics.errors();
        scope.constants.try_emplace(name, LoopScope::Declared{variable.name.where, {}});
        scope.record.declare(DeclarationKind::Constant, name, variable.name.where, variable.where, scope.loop.origin);
        declare_constant(scope, variable);
        if (scope.diagnostics.errors() == errors) continue;
        scope.excused.insert(name);
        scope.valueless.insert(name);
    }
}

std::optional<Span> variable_named(const LoopScope& scope, std::string_view name) {
    if (const auto shared = scope.shared.find(std::string(name)); shared != scope.shared.end())
        return scope.loop.shared[shared->second].origin;
    for (const Id<ClosedLoop::Controller> id : scope.loop.controllers.ids()) {
        const LoopScope::Inside& inside = scope.inside[id.index];
        const auto internal = inside.internals.find(name);
        if (internal != inside.internals.end()) return scope.chart(id).variables[internal->second].origin;
        const auto steps = name.size() > 1 && name[0] == 'X' ? inside.steps.find(name.substr(1)) : inside.steps.end();
        if (steps != inside.steps.end()) return scope.chart(id).steps[steps->second.front()].origin;
    }
    return {};
}

void check_constant_names(LoopScope& scope) {
    for (const Named& constant : scope.loop.constants)
        if (const auto other = variable_named(scope, constant.name))
            scope.diagnostics.add(messages::duplicate_name(constant.origin, "name", constant.name, *other));
}

std::optional<Term> constant_named(LoopScope& scope, std::string_view name, Span where) {
    const auto known = scope.constants.find(name);
    if (known == scope.constants.end()) return {};
    scope.record.refer(where, known->second.where);
    if (!known->second.number) return {};
    const Named& constant = scope.loop.constants[*known->second.number];
    Exprs& exprs = scope.loop.exprs;
    switch (constant.kind) {
    case Named::Kind::Boolean: return Term{exprs.constant(constant.value != 0), TermKind::Boolean};
    case Named::Kind::Integer: return Term{exprs.integer(constant.value), TermKind::Integer};
    case Named::Kind::Duration: return Term{exprs.duration(constant.value), TermKind::Duration};
    }
    unreachable();
}

Terms constant_terms(LoopScope& scope, std::string_view user) {
    Terms terms(scope.file, scope.loop.exprs, scope.diagnostics);
    terms.name = [&scope, user = std::string(user)](const tree::Expr& node) {
        const bool simple = node.op == tree::Op::Name;
        const std::string_view name = scope.file.text(node.word);
        if (simple)
            if (const auto constant = constant_named(scope, name, node.where)) return *constant;
        if (simple && scope.valueless.contains(name)) return Term{};
        const auto& known = scope.last_declarations;
        const auto last = simple ? known.find(without_indices(name)) : known.end();
        if (last != known.end() && node.where.begin < last->second.whole.end) {
            scope.record.refer(node.where, last->second.name);
            scope.diagnostics.add(messages::constant_below(node.where, name));
        } else {
            scope.diagnostics.add(messages::not_constant(node.where, user));
        }
        return Term{};
    };
    return terms;
}

}  // namespace grafverif
