// SPDX-License-Identifier: MIT
// Reads statements. A call of a function block becomes assignments to its inputs, the call, and assignments of its
// outputs.
#include <algorithm>
#include <string>

#include "read/program/scope.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"

namespace grafverif::program {

namespace {

using Kind = Statement::Kind;

}  // namespace

Program::Body Reader::block(const st::Block& statements) {
    Program::Body body;
    for (const Id<st::Statement> one : statements) statement(one, body);
    return body;
}

void Reader::statement(Id<st::Statement> id, Program::Body& body) {
    const st::Statement& from = file_->statements[id];
    Statement made;
    made.origin = from.where;
    switch (from.kind) {
    case st::StatementKind::Assign: {
        const auto cell = target(from.target);
        const auto value = expression(from.value);
        if (cell && value) assign(*cell, *value, from.where, body);
        return;
    }
    case st::StatementKind::Call: return invoke(from.value, body);
    case st::StatementKind::If: return if_statement(from, body);
    case st::StatementKind::Case: return case_statement(from, body);
    case st::StatementKind::For: return for_statement(from, body);
    case st::StatementKind::While:
    case st::StatementKind::Repeat: {
        made.kind = from.kind == st::StatementKind::While ? Kind::While : Kind::Repeat;
        const auto value = expression(from.value);
        const auto node =
            value ? converted(*value, bool_, file_->exprs[from.value].where, "the condition") : std::nullopt;
        ++loops_;
        Program::Arm arm;
        arm.body = block(from.branches.front().body);
        --loops_;
        if (!node) return;
        made.value = *node;
        made.arms.push_back(std::move(arm));
        break;
    }
    case st::StatementKind::Return:
        if (action_) return reject(from.where, "RETURN in an action", "use IF");
        made.kind = Kind::Return;
        break;
    case st::StatementKind::Exit:
        if (loops_ == 0) return reject(from.where, "EXIT outside a loop", "remove it, or use RETURN");
        made.kind = Kind::Exit;
        break;
    }
    body.push_back(program.statements.add(std::move(made)));
}

/// Returns a variable that a statement may assign.
std::optional<Reader::Found> Reader::target(Id<st::Expr> path) {
    const Span where = file_->exprs[path].where;
    const auto found = variable(path);
    if (!found) return {};
    if (program.types[found->type].kind == Type::Kind::Block)
        return reject(where, "an assignment to an instance", "assign its inputs"), std::nullopt;
    if (found->variable->constant)
        return reject(where, "an assignment to a constant", "declare it without CONSTANT"), std::nullopt;
    if (found->inside && chart_units_.contains(program.types[found->instance->type].unit.index))
        return reject(where, "an assignment to a step or to the control of an action",
                      "write transitions or action blocks"),
               std::nullopt;
    if (found->inside && found->variable->section != Variable::Section::Input)
        return reject(where, "an assignment to an output of an instance", "assign its inputs"), std::nullopt;
    return found;
}

void Reader::assign(const Found& cell, const Typed& value, Span where, Program::Body& body) {
    const auto node = converted(value, cell.type, where, "the value");
    if (!node) return;
    if (cell.instance) {  // the preset time of a timer bounds the time that it counts
        const Unit& block = program.units[program.types[cell.instance->type].unit];
        if (block.elapsed && cell.variable->name == "PT") {
            const auto known = value_of(*node);
            cell.instance->longest = std::max(cell.instance->longest, known.value_or(program.types[time_].high));
        }
    }
    Statement made;
    made.kind = Kind::Assign;
    made.place = cell.place;
    made.type = cell.type;
    made.value = *node;
    made.origin = where;
    body.push_back(program.statements.add(std::move(made)));
}

void Reader::invoke(Id<st::Expr> call, Program::Body& body) {
    const st::Expr from = file_->exprs[call];
    const st::Expr callee = file_->exprs[from.first];
    if (callee.op != st::Op::Name) return reject(callee.where, "this call", "call an instance of this unit");
    if (const auto unit = units_.find(callee.word.index);
        unit != units_.end() && !scopes_[unit_.index].variables.contains(callee.word.index)) {
        const bool function = file_->units[unit->second].kind == st::UnitKind::Function;
        return reject(callee.where, function ? "a function call as a statement" : "a call of a type",
                      function ? "assign its value" : "declare an instance and call it");
    }
    if (scopes_[unit_.index].members.contains({callee.word.index, file_->intern("A").index}))
        return reject(callee.where, "a call of an action", "associate the action with a step");
    const auto found = named(callee.word, callee.where);
    if (!found) return;
    const Type& type = program.types[found->type];
    if (type.kind != Type::Kind::Block) {
        diagnostics->add(messages::program_type_mismatch(callee.where, "the callee", "an instance of a function block",
                                                         "`" + type.name + "`"));
        return;
    }
    const Id<Unit> block = type.unit;
    const std::vector<Id<st::Expr>> parts = st::operands(*file_, call);
    Program::Body results;
    std::vector<std::size_t> inputs;
    for (std::size_t i = 0; i < program.units[block].variables.size(); ++i)
        if (program.units[block].variables[i].section == Variable::Section::Input) inputs.push_back(i);
    std::vector<std::uint32_t> assigned;
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const st::Expr part = file_->exprs[parts[i]];
        const bool named_one = part.op == st::Op::Argument || part.op == st::Op::Result;
        std::optional<std::size_t> index;
        if (named_one) {
            const auto known = scopes_[block.index].variables.find(part.word.index);
            if (known != scopes_[block.index].variables.end()) index = known->second;
        } else if (i - 1 < inputs.size()) index = inputs[i - 1];
        const auto wanted = part.op == st::Op::Result ? Variable::Section::Output : Variable::Section::Input;
        if (!index || program.units[block].variables[*index].section != wanted) {
            if (named_one && !index) diagnostics->add(messages::unknown(part.where, "variable", text(part.word), ""));
            else reject(part.where, "this argument", "name an input with `:=` or an output with `=>`");
            continue;
        }
        Variable& formal = program.units[block].variables[*index];
        const Found cell{
            {found->place.global, found->place.offset + formal.offset}, formal.type, &formal, found->variable, true};
        if (part.op == st::Op::Result) {
            const auto to = target(part.first);
            const Id<Node> read = add(Program::Op::Read, cell.type, {}, part.where);
            program.nodes[read].place = cell.place;
            if (to) assign(*to, {read, false}, part.where, results);
            continue;
        }
        if (std::ranges::find(assigned, formal.offset) != assigned.end()) {
            reject(part.where, "a second value of this input", "give each input once");
            continue;
        }
        assigned.push_back(formal.offset);
        const auto value = expression(named_one ? part.first : parts[i]);
        if (value) assign(cell, *value, part.where, body);
    }
    Statement made;
    made.kind = Kind::Invoke;
    made.place = found->place;
    made.unit = block;
    made.origin = from.where;
    body.push_back(program.statements.add(std::move(made)));
    body.insert(body.end(), results.begin(), results.end());
}

void Reader::if_statement(const st::Statement& from, Program::Body& body) {
    Statement made;
    made.kind = Kind::If;
    made.origin = from.where;
    bool ok = true;
    for (const st::Branch& branch : from.branches) {
        Program::Arm arm;
        if (!branch.conditions.empty()) {
            const auto value = expression(branch.conditions.front());
            const auto node =
                value ? converted(*value, bool_, file_->exprs[branch.conditions.front()].where, "the condition")
                      : std::nullopt;
            ok = ok && node;
            if (node) arm.condition = *node;
        }
        arm.body = block(branch.body);
        made.arms.push_back(std::move(arm));
    }
    if (ok) body.push_back(program.statements.add(std::move(made)));
}

void Reader::case_statement(const st::Statement& from, Program::Body& body) {
    Statement made;
    made.kind = Kind::Case;
    made.origin = from.where;
    const auto selector = expression(from.value);
    std::optional<Id<Type>> of;
    if (selector) {
        const Type::Kind kind = type(*selector).kind;
        if (selector->literal ||
            (kind != Type::Kind::Integer && kind != Type::Kind::Enumeration && kind != Type::Kind::Bits))
            diagnostics->add(messages::program_type_mismatch(file_->exprs[from.value].where, "the selector",
                                                             "an integer or an enumeration", described(*selector)));
        else of = program.nodes[selector->node].type;
    }
    for (const st::Branch& branch : from.branches) {
        Program::Arm arm;
        if (of)
            for (const Id<st::Expr> one : branch.conditions) label(one, *of, arm);
        arm.body = block(branch.body);
        made.arms.push_back(std::move(arm));
    }
    if (!of) return;
    made.value = selector->node;
    made.type = *of;
    body.push_back(program.statements.add(std::move(made)));
}

void Reader::label(Id<st::Expr> expr, Id<Type> of, Program::Arm& arm) {
    const st::Expr from = file_->exprs[expr];
    std::vector<Id<st::Expr>> bounds = {expr};
    if (from.op == st::Op::Range) bounds = st::operands(*file_, expr);
    std::vector<std::int64_t> values;
    for (const Id<st::Expr> bound : bounds) {
        const auto value = expression(bound);
        const auto node = value ? converted(*value, of, file_->exprs[bound].where, "the label") : std::nullopt;
        if (!node) return;
        const auto known = value_of(*node);
        if (!known) {
            diagnostics->add(messages::not_constant(file_->exprs[bound].where, "a label of CASE"));
            return;
        }
        values.push_back(*known);
    }
    if (values.front() > values.back()) return reject(from.where, "an empty range", "write the smaller label first");
    arm.labels.emplace_back(values.front(), values.back());
}

void Reader::for_statement(const st::Statement& from, Program::Body& body) {
    Statement made;
    made.kind = Kind::For;
    made.origin = from.where;
    const auto cell = target(from.target);
    if (cell && program.types[cell->type].kind != Type::Kind::Integer) {
        diagnostics->add(messages::program_type_mismatch(file_->exprs[from.target].where, "the variable of FOR",
                                                         "an integer", "`" + program.types[cell->type].name + "`"));
        return;
    }
    std::array<std::optional<Id<Node>>, 2> bounds;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto value = expression(from.range[i]);
        if (value && cell) bounds[i] = converted(*value, cell->type, file_->exprs[from.range[i]].where, "the bound");
    }
    bool ok = cell && bounds[0] && bounds[1];
    if (from.range[2].valid()) {
        const auto value = expression(from.range[2]);
        const auto known = value ? value_of(value->node) : std::nullopt;
        const Span where = file_->exprs[from.range[2]].where;
        if (value && !known) diagnostics->add(messages::not_constant(where, "the step of FOR"));
        if (known && (*known == 0 || *known > 2147483647LL || *known < -2147483648LL))
            reject(where, "this step", "use a nonzero step within DINT");
        ok = ok && known && *known != 0;
        made.step = known.value_or(1);
    }
    ++loops_;
    Program::Arm arm;
    arm.body = block(from.branches.front().body);
    --loops_;
    if (!ok) return;
    made.place = cell->place;
    made.type = cell->type;
    made.value = *bounds[0];
    made.last = *bounds[1];
    made.arms.push_back(std::move(arm));
    body.push_back(program.statements.add(std::move(made)));
}

}  // namespace grafverif::program
