// SPDX-License-Identifier: MIT
// Resolves the parameters and variables of a component. A constant has its declared type or, if no type is declared,
// the type of its default. Without a type and a default, the constant is an integer. A default can name constants that
// are declared later. Therefore defaults are resolved in the order of dependency.
#include <algorithm>
#include <deque>
#include <vector>

#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/resolve/component_scope.hpp"
#include "syntax/resolve/expand.hpp"
#include "syntax/resolve/nearest.hpp"

namespace grafverif {

using ValueKind = Component::ValueKind;

Span origin(const Component& component, const ComponentScope::Symbol& symbol) {
    return std::visit(overloaded{
                          [&](Id<Component::Parameter> id) { return component.parameters[id].origin; },
                          [&](Id<Component::Variable> id) { return component.variables[id].origin; },
                          [&](Id<Component::Clock> id) { return component.clocks[id].origin; },
                      },
                      symbol);
}

TermKind kind_of(ValueKind kind) {
    switch (kind) {
    case ValueKind::Boolean: return TermKind::Boolean;
    case ValueKind::Integer: return TermKind::Integer;
    case ValueKind::Duration: return TermKind::Duration;
    }
    unreachable();
}

namespace {

DeclarationKind kind_of(const Component& component, const ComponentScope::Symbol& symbol) {
    if (std::holds_alternative<Id<Component::Clock>>(symbol)) return DeclarationKind::Clock;
    const auto* parameter = std::get_if<Id<Component::Parameter>>(&symbol);
    if (parameter == nullptr) return DeclarationKind::Own;
    switch (component.parameters[*parameter].kind) {
    case Component::ParameterKind::Input: return DeclarationKind::InputParameter;
    case Component::ParameterKind::Output: return DeclarationKind::OutputParameter;
    case Component::ParameterKind::Constant: return DeclarationKind::Constant;
    }
    unreachable();
}

}  // namespace

void declare(ComponentScope& scope, tree::Name name, ComponentScope::Symbol symbol, Span whole) {
    const InCopy copy(scope.diagnostics, scope.file, name);
    const auto [known, fresh] = scope.symbols.try_emplace(name.word, symbol);
    scope.record.declare(kind_of(scope.component, symbol), scope.text(name), name.where, whole, scope.component.origin);
    if (!fresh)
        scope.diagnostics.add(duplicate(name, "name", scope.text(name), origin(scope.component, known->second)));
}

// -- names -----------------------------------------------------------------------------------------------------------

namespace {

Term unknown_name(ComponentScope& scope, const tree::Expr& node) {
    if (node.op == tree::Op::Member) {
        scope.diagnostics.add(messages::unknown(node.where, "variable", scope.file.text(node.word), ""));
        return {};
    }
    const std::string_view name = scope.file.text(node.word);
    if (scope.diagnostics.full())
        return scope.diagnostics.add(messages::unknown(node.where, "variable", name, "")), Term{};
    Nearest nearest(name);
    for (const auto& parameter : scope.component.parameters) nearest.offer(parameter.name);
    for (const auto& variable : scope.component.variables) nearest.offer(variable.name);
    for (const auto& clock : scope.component.clocks) nearest.offer(clock.name);
    scope.diagnostics.add(messages::unknown(node.where, "variable", name, nearest.best()));
    return {};
}

Term symbol_term(ComponentScope& scope, const tree::Expr& node, const ComponentScope::Symbol& symbol) {
    scope.record.refer(node.where, origin(scope.component, symbol));
    return std::visit(overloaded{
                          [&](Id<Component::Parameter> id) {
                              return Term{scope.component.exprs.leaf(Op::Parameter, id.index),
                                          kind_of(scope.component.parameters[id].value)};
                          },
                          [&](Id<Component::Variable> id) {
                              return Term{scope.component.exprs.leaf(Op::Variable, id.index),
                                          kind_of(scope.component.variables[id].value)};
                          },
                          [&](Id<Component::Clock>) {
                              return Term{{}, TermKind::Clock};
                          },
                      },
                      symbol);
}

bool is_constant_symbol(const Component& component, const ComponentScope::Symbol& symbol) {
    const auto* parameter = std::get_if<Id<Component::Parameter>>(&symbol);
    return parameter != nullptr && component.parameters[*parameter].kind == Component::ParameterKind::Constant;
}

}  // namespace

Terms all_terms(ComponentScope& scope) {
    Terms terms(scope.file, scope.component.exprs, scope.diagnostics);
    terms.name = [&scope](const tree::Expr& node) {
        const auto found = node.op == tree::Op::Name ? scope.symbols.find(node.word) : scope.symbols.end();
        return found == scope.symbols.end() ? unknown_name(scope, node) : symbol_term(scope, node, found->second);
    };
    return terms;
}

Terms constant_terms(ComponentScope& scope, std::string_view user) {
    Terms terms(scope.file, scope.component.exprs, scope.diagnostics);
    terms.name = [&scope, user = std::string(user)](const tree::Expr& node) {
        const auto found = node.op == tree::Op::Name ? scope.symbols.find(node.word) : scope.symbols.end();
        if (found == scope.symbols.end()) return unknown_name(scope, node);
        const Term term = symbol_term(scope, node, found->second);
        if (is_constant_symbol(scope.component, found->second)) return term;
        scope.diagnostics.add(messages::not_constant(node.where, user));
        return Term{};
    };
    return terms;
}

// -- constants --------------------------------------------------------------------------------------------------------

namespace {

struct Constant {
    const tree::Variable* written = nullptr;
    Id<Component::Parameter> id = {};
    std::vector<std::size_t> users = {};  ///< constants whose defaults read this constant
    std::size_t needs = 0;                ///< number of defaults that must be resolved first
};

/// Collects the names in a term. The recursion is safe, because the depth of terms is limited; their number of operands
/// is not.
void names_in(const tree::File& file, Id<tree::Expr> node, std::vector<Id<tree::Word>>& names) {
    const tree::Expr& written = file.exprs[node];
    if (written.op == tree::Op::Name) names.push_back(written.word);
    for (Id<tree::Expr> operand = written.first; operand.valid(); operand = file.exprs[operand].next)
        names_in(file, operand, names);
}

void link_defaults(ComponentScope& scope, std::vector<Constant>& constants) {
    std::unordered_map<Id<Component::Parameter>, std::size_t> positions;
    for (std::size_t i = 0; i < constants.size(); ++i) positions.emplace(constants[i].id, i);
    for (std::size_t i = 0; i < constants.size(); ++i) {
        if (!constants[i].written->value.valid()) continue;
        std::vector<Id<tree::Word>> names;
        names_in(scope.file, constants[i].written->value, names);
        for (const Id<tree::Word> word : names) {
            const auto symbol = scope.symbols.find(word);
            if (symbol == scope.symbols.end() || !std::holds_alternative<Id<Component::Parameter>>(symbol->second))
                continue;
            const auto used = positions.find(std::get<Id<Component::Parameter>>(symbol->second));
            if (used == positions.end()) continue;
            constants[used->second].users.push_back(i);
            ++constants[i].needs;
        }
    }
}

void resolve_default(ComponentScope& scope, const Constant& constant) {
    Component::Parameter& parameter = scope.component.parameters[constant.id];
    const tree::Variable& written = *constant.written;
    if (written.type == tree::TypeWord::Bool) parameter.value = ValueKind::Boolean;
    else if (written.type == tree::TypeWord::Duration) parameter.value = ValueKind::Duration;
    else parameter.value = ValueKind::Integer;
    if (!written.value.valid()) return;
    Terms terms = constant_terms(scope, "a default");
    if (written.type == tree::TypeWord::None) {
        const Term term = terms.resolve(written.value);
        if (term.kind == TermKind::Wrong) return;
        parameter.initial = term.expr;
        if (term.kind == TermKind::Boolean) parameter.value = ValueKind::Boolean;
        if (term.kind == TermKind::Duration) parameter.value = ValueKind::Duration;
        return;
    }
    const Id<Expr> value = terms.resolve(written.value, kind_of(parameter.value), '`' + parameter.name + '`');
    if (value.valid()) parameter.initial = value;
}

void resolve_constants(ComponentScope& scope, std::vector<Constant>& constants) {
    link_defaults(scope, constants);
    std::deque<std::size_t> ready;
    for (std::size_t i = 0; i < constants.size(); ++i)
        if (constants[i].needs == 0) ready.push_back(i);
    std::size_t done = 0;
    for (; !ready.empty(); ++done) {
        const Constant& constant = constants[ready.front()];
        ready.pop_front();
        resolve_default(scope, constant);
        for (const std::size_t user : constant.users)
            if (--constants[user].needs == 0) ready.push_back(user);
    }
    if (done == constants.size()) return;
    const auto cyclic = std::ranges::find_if(constants, [](const Constant& constant) { return constant.needs > 0; });
    scope.diagnostics.add(messages::constant_cycle(cyclic->written->name.where, scope.text(cyclic->written->name)));
}

// -- inputs, outputs, variables ---------------------------------------------------------------------------------------

ValueKind value_kind(ComponentScope& scope, const tree::Variable& written) {
    switch (written.type) {
    case tree::TypeWord::None:
    case tree::TypeWord::Bool: return ValueKind::Boolean;
    case tree::TypeWord::Int: return ValueKind::Integer;
    case tree::TypeWord::Duration:
        scope.diagnostics.add(messages::misplaced_type(
            written.where, "durations are allowed only for constants; declare a `clock` to measure time"));
        return ValueKind::Boolean;
    }
    unreachable();
}

/// Resolves the range and the value at power-on of outputs and variables.
template <class Declared>
void resolve_range(ComponentScope& scope, const tree::Variable& written, Declared& declared) {
    Terms range = constant_terms(scope, "a range");
    if (written.range) {
        const Id<Expr> low = range.resolve(written.range->low, TermKind::Integer, "a range");
        const Id<Expr> high = range.resolve(written.range->high, TermKind::Integer, "a range");
        if (low.valid()) declared.low = low;
        if (high.valid()) declared.high = high;
    } else if (declared.value == ValueKind::Integer) {
        scope.diagnostics.add(messages::unbounded_integer(written.where, declared.name));
    }
    if (!written.value.valid()) return;
    Terms value = constant_terms(scope, "a value at power-on");
    if (written.type == tree::TypeWord::None) {
        const Term term = value.resolve(written.value);
        if (term.kind == TermKind::Integer)
            scope.diagnostics.add(messages::unbounded_integer(written.where, declared.name));
        if (term.kind == TermKind::Duration)
            scope.diagnostics.add(messages::misplaced_type(
                written.where, "durations are allowed only for constants; declare a `clock` to measure time"));
        if (term.kind == TermKind::Boolean) declared.initial = term.expr;
        return;
    }
    const Id<Expr> initial = value.resolve(written.value, kind_of(declared.value), '`' + declared.name + '`');
    if (initial.valid()) declared.initial = initial;
}

Component::ParameterKind parameter_kind(tree::VariableKind kind) {
    switch (kind) {
    case tree::VariableKind::Input: return Component::ParameterKind::Input;
    case tree::VariableKind::Output: return Component::ParameterKind::Output;
    case tree::VariableKind::Constant: return Component::ParameterKind::Constant;
    case tree::VariableKind::Internal:
    case tree::VariableKind::Own: break;  // the grammar excludes these types of parameters
    }
    unreachable();
}

void check_input(ComponentScope& scope, const tree::Variable& written) {
    if (written.range)
        scope.diagnostics.add(messages::misplaced_type(
            written.where, "an integer input has the range of its argument; remove the range"));
    if (written.value.valid())
        scope.diagnostics.add(messages::misplaced_value(scope.file.exprs[written.value].where, "input"));
}

void check_constant(ComponentScope& scope, const tree::Variable& written) {
    if (written.range)
        scope.diagnostics.add(
            messages::misplaced_type(written.where, "a constant cannot have a range; remove the range"));
}

}  // namespace

void resolve_parameters(ComponentScope& scope, const tree::Component& written) {
    std::vector<Constant> constants;
    std::vector<std::pair<const tree::Variable*, Id<Component::Parameter>>> outputs;
    for (const tree::Variables& group : written.parameters) {
        for (const tree::Variable& variable : group.variables) {
            Component::Parameter parameter;
            parameter.name = scope.text(variable.name);
            parameter.kind = parameter_kind(group.kind);
            parameter.origin = variable.name.where;
            if (group.kind != tree::VariableKind::Constant) parameter.value = value_kind(scope, variable);
            const Id<Component::Parameter> id = scope.component.parameters.add(std::move(parameter));
            declare(scope, variable.name, id, variable.where);
            if (group.kind == tree::VariableKind::Input) check_input(scope, variable);
            if (group.kind == tree::VariableKind::Output) outputs.emplace_back(&variable, id);
            if (group.kind == tree::VariableKind::Constant) {
                check_constant(scope, variable);
                constants.push_back({&variable, id, {}, 0});
            }
        }
    }
    resolve_constants(scope, constants);
    for (const auto& [variable, id] : outputs) {
        Component::Parameter parameter = scope.component.parameters[id];
        resolve_range(scope, *variable, parameter);
        scope.component.parameters[id] = std::move(parameter);
    }
}

void resolve_own_variables(ComponentScope& scope, const tree::Variables& written) {
    for (const tree::Variable& variable : written.variables) {
        const InCopy copy(scope.diagnostics, scope.file, variable.name);
        Component::Variable own;
        own.name = scope.text(variable.name);
        own.value = value_kind(scope, variable);
        own.origin = variable.name.where;
        resolve_range(scope, variable, own);
        declare(scope, variable.name, scope.component.variables.add(std::move(own)), variable.where);
    }
}

}  // namespace grafverif
