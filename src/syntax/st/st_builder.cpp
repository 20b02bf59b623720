// SPDX-License-Identifier: MIT
#include "syntax/st/st_builder.hpp"

#include <algorithm>
#include <utility>

#include "support/messages.hpp"

namespace grafverif::st {

// -- units ------------------------------------------------------------------------------------------------------------

void Builder::globals(std::vector<Variable> variables) {
    for (Variable& variable : variables) file_->globals.push_back(std::move(variable));
}

void Builder::unit(UnitKind kind, Name name, Unit body, Span where) {
    body.kind = kind;
    body.name = name;
    body.where = where;
    file_->units.push_back(std::move(body));
}

void Builder::unit(UnitKind kind, Name name, Type result, Unit body, Span where) {
    body.result = std::move(result);
    unit(kind, name, std::move(body), where);
}

Type Builder::enumeration(std::vector<Name> values) const {
    Type type{values.front(), {}, {}, true, {}};
    type.values = std::move(values);
    return type;
}

void Builder::type(Name name, Type type, Id<Expr> initial, Span where) {
    file_->types.push_back({name, std::move(type), initial, false, where, {}});
}

void Builder::structure(Name name, std::vector<Variable> members, Span where) {
    file_->types.push_back({name, {}, {}, true, where, std::move(members)});
}

/// Returns the type of an array with one dimension per range. If a range is not written as `LOW..HIGH`, the bounds of
/// its dimension are invalid.
Type Builder::array(const std::vector<Id<Expr>>& ranges, Type element) const {
    element.composite = true;
    std::vector<std::array<Id<Expr>, 2>> dimensions;
    for (const Id<Expr> range : ranges) {
        const std::vector<Id<Expr>> ends = operands(*file_, range);
        const bool complete = file_->exprs[range].op == Op::Range && ends.size() == 2;
        dimensions.push_back(complete ? std::array{ends[0], ends[1]} : std::array<Id<Expr>, 2>{});
    }
    element.dimensions.insert(element.dimensions.begin(), dimensions.begin(), dimensions.end());
    return element;
}

void Builder::task(Name name, std::vector<Id<Expr>> arguments, Span where) {
    file_->tasks.push_back({name, std::move(arguments), where});
}

void Builder::instance(Name name, Name task, Name type, std::vector<Id<Expr>> arguments, Span where) {
    file_->instances.push_back({name, task, type, std::move(arguments), where});
}

std::vector<Variable> Builder::section(Section section, Qualifiers qualifiers, std::vector<Variable> variables) const {
    for (Variable& variable : variables) {
        variable.section = section;
        variable.constant = qualifiers.constant;
        variable.retain = qualifiers.retain;
    }
    return variables;
}

std::vector<Variable> Builder::variables(std::vector<Name> names, std::string address, Type type, Id<Expr> initial,
                                         Span where) const {
    std::vector<Variable> declared;
    for (const Name name : names) {
        Variable variable;
        variable.name = name;
        variable.type = type;
        variable.initial = initial;
        variable.address = address;
        variable.where = where;
        declared.push_back(std::move(variable));
    }
    return declared;
}

void Builder::add_variables(Unit& unit, std::vector<Variable> variables) const {
    for (Variable& variable : variables) unit.variables.push_back(std::move(variable));
}

Network& Builder::chart(Unit& unit, Span where) const {
    if (unit.networks.empty()) unit.networks.emplace_back().where = where;
    return unit.networks.front();
}

void Builder::step(Unit& unit, bool initial, Name name, std::vector<Association> actions, Span begin, Span end) const {
    const Span where = joined(begin, name.where);
    chart(unit, where).steps.push_back({initial, name, std::move(actions), {}, where, joined(begin, end)});
}

void Builder::transition(Unit& unit, Transition transition) const {
    chart(unit, transition.where).transitions.push_back(std::move(transition));
}

void Builder::action(Unit& unit, Name name, Block body, Span begin, Span end) const {
    unit.actions.push_back({name, std::move(body), false, joined(begin, name.where), joined(begin, end)});
}

/// Builds an action block `NAME (QUALIFIER, TIME, INDICATORS)`. The grammar parses the qualifier as a name. The default
/// qualifier is N.
Association Builder::association(Name action, std::vector<Id<Expr>> arguments, Span where) {
    Association association;
    association.action = action;
    association.where = where;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const Expr& argument = file_->exprs[arguments[i]];
        if (i == 0 && argument.op == Op::Name) association.qualifier = capitals(file_->text(argument.word));
        else if (i == 1) association.time = arguments[i];
        else association.unread = true;
    }
    return association;
}

// -- statements -------------------------------------------------------------------------------------------------------

Id<Statement> Builder::assign(Id<Expr> target, Id<Expr> value, Span where) {
    return file_->statements.add({StatementKind::Assign, target, value, {}, where, {}});
}

Id<Statement> Builder::call_statement(Id<Expr> call, Span where) {
    return file_->statements.add({StatementKind::Call, {}, call, {}, where, {}});
}

Id<Statement> Builder::if_statement(Id<Expr> condition, Block body, std::vector<Branch> alternatives, Branch otherwise,
                                    Span where) {
    std::vector<Branch> branches = {branch({condition}, std::move(body), file_->exprs[condition].where)};
    for (Branch& alternative : alternatives) branches.push_back(std::move(alternative));
    if (otherwise.where.source.valid()) branches.push_back(std::move(otherwise));
    return file_->statements.add({StatementKind::If, {}, {}, std::move(branches), where, {}});
}

Id<Statement> Builder::case_statement(Id<Expr> selector, std::vector<Branch> cases, Branch otherwise, Span where) {
    if (otherwise.where.source.valid()) cases.push_back(std::move(otherwise));
    return file_->statements.add({StatementKind::Case, {}, selector, std::move(cases), where, {}});
}

Id<Statement> Builder::loop(StatementKind kind, Block body, Span where, Id<Expr> condition) {
    return file_->statements.add({kind, {}, condition, {branch({}, std::move(body), where)}, where, {}});
}

Id<Statement> Builder::for_statement(Id<Expr> variable, std::array<Id<Expr>, 3> range, Block body, Span where) {
    return file_->statements.add(
        {StatementKind::For, variable, {}, {branch({}, std::move(body), where)}, where, range});
}

Id<Statement> Builder::plain(StatementKind kind, Span where) {
    return file_->statements.add({kind, {}, {}, {}, where, {}});
}

Branch Builder::branch(std::vector<Id<Expr>> conditions, Block body, Span where) const {
    return {std::move(conditions), std::move(body), where};
}

// -- expressions ------------------------------------------------------------------------------------------------------

void Builder::adopt(Id<Expr> node, Id<Expr> operand) {
    Expr& parent = file_->exprs[node];
    const std::size_t depth = file_->exprs[operand].depth + std::size_t{1};
    if (depth > deepest_expression) {
        if (parent.depth <= deepest_expression) diagnostics_->add(messages::too_deep(parent.where, deepest_expression));
        return;
    }
    parent.depth = std::max(parent.depth, static_cast<std::uint16_t>(depth));
    append(file_->exprs, node, operand);
}

Id<Expr> Builder::node(Op op, std::initializer_list<Id<Expr>> operands, Span where) {
    const Id<Expr> id = leaf(op, where);
    for (const Id<Expr> operand : operands) adopt(id, operand);
    if (file_->exprs[id].first.valid() || operands.size() == 0) return id;
    file_->exprs[id].op = Op::False;  // the excessive depth has already been reported
    return id;
}

Id<Expr> Builder::leaf(Op op, Span where) {
    Expr expr;
    expr.op = op;
    expr.where = where;
    return file_->exprs.add(expr);
}

Id<Expr> Builder::number(Op op, std::int64_t value, Span where) {
    const Id<Expr> id = leaf(op, where);
    file_->exprs[id].value = value;
    return id;
}

void Builder::set_name(Id<Expr> id, Name name) {
    file_->exprs[id].word = name.word;
    file_->exprs[id].name = name.where;
}

Id<Expr> Builder::word(Op op, Name word) {
    const Id<Expr> id = leaf(op, word.where);
    set_name(id, word);
    return id;
}

Id<Expr> Builder::other(Span where) {
    const Id<Expr> id = leaf(Op::Other, where);
    file_->exprs[id].word = file_->intern("?");
    return id;
}

Id<Expr> Builder::unary(Op op, Id<Expr> operand, Span where) { return node(op, {operand}, where); }

Id<Expr> Builder::binary(Op op, Id<Expr> left, Id<Expr> right, Span where) {
    const bool joins = (op == Op::And || op == Op::Or || op == Op::Xor) && file_->exprs[left].op == op;
    if (!joins) return node(op, {left, right}, where);
    file_->exprs[left].where = where;
    adopt(left, right);
    return left;
}

Id<Expr> Builder::bracketed(Id<Expr> expression, Span where) {
    file_->exprs[expression].where = where;
    return expression;
}

Id<Expr> Builder::member(Id<Expr> owner, Name name, Span where) {
    const Id<Expr> id = node(Op::Member, {owner}, where);
    set_name(id, name);
    return id;
}

Id<Expr> Builder::index(Id<Expr> array, const std::vector<Id<Expr>>& indices, Span where) {
    const Id<Expr> id = node(Op::Index, {array}, where);
    for (const Id<Expr> one : indices) adopt(id, one);
    return id;
}

Id<Expr> Builder::call(Id<Expr> callee, const std::vector<Id<Expr>>& arguments, Span where) {
    const Id<Expr> id = node(Op::Call, {callee}, where);
    for (const Id<Expr> one : arguments) adopt(id, one);
    return id;
}

Id<Expr> Builder::argument(Op op, Name formal, Id<Expr> value, Span where) {
    const Id<Expr> id = node(op, {value}, where);
    set_name(id, formal);
    return id;
}

}  // namespace grafverif::st
