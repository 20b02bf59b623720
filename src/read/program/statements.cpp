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
        if (cell && program.types[cell->type].kind == Type::Kind::Unsupported) {
            const st::Op op = file_->exprs[from.value].op;  // a literal is permitted: no statement can read it
            if (op != st::Op::Other)
                reject(from.where, "a variable of the type `" + program.types[cell->type].name + "`",
                       "use BOOL, TIME or an integer of at most 32 bits");
            return;
        }
        if (cell && is_composite(cell->type)) {
            if (const auto whole = variable(from.value)) copy(*cell, *whole, from.where, body);
            return;
        }
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
    if (file_->dialect == st::Dialect::Codesys && st::capitals(found->variable->name) == "SFCINIT")
        return reject(where, "an assignment to `SFCInit`", "use `SFCReset`"), std::nullopt;
    const Type& type = program.types[found->type];
    if (type.kind == Type::Kind::Block && !is_composite(found->type))
        return reject(where, "an assignment to an instance", "assign its inputs"), std::nullopt;
    if (found->constant)
        return reject(where, "an assignment to a constant", "declare it without CONSTANT"), std::nullopt;
    if (found->inside && chart_units_.contains(found->block.index))
        return reject(where, "an assignment to a step or to the control of an action",
                      "write transitions or action blocks"),
               std::nullopt;
    if (found->locked)
        return reject(where, "an assignment to an output of an instance", "assign its inputs"), std::nullopt;
    refer_target(path, found->variable->origin);
    return found;
}

/// True if a variable of this type can be assigned as a whole and has several memory cells: an array or structure
/// without function block instances.
bool Reader::is_composite(Id<Type> id) const {
    const Type& type = program.types[id];
    if (type.kind == Type::Kind::Array) return is_composite(type.element) || is_elementary(type.element);
    if (type.kind != Type::Kind::Block || program.units[type.unit].kind != Unit::Kind::Structure) return false;
    return std::ranges::all_of(program.units[type.unit].variables, [&](const Variable& member) {
        return is_elementary(member.type) || is_composite(member.type);
    });
}

bool Reader::is_elementary(Id<Type> id) const {
    const Type::Kind kind = program.types[id].kind;
    return kind != Type::Kind::Block && kind != Type::Kind::Array && kind != Type::Kind::Unsupported;
}

/// Adds statements that copy all memory cells of the variable `from` to the variable `to`.
void Reader::copy(const Found& to, const Found& from, Span where, Program::Body& body) {
    if (to.type != from.type) {
        diagnostics->add(messages::program_type_mismatch(where, "the value", "`" + program.types[to.type].name + "`",
                                                         "of type `" + program.types[from.type].name + "`"));
        return;
    }
    if (from.constant)
        return reject(where, "a copy of a complete constant array or structure",
                      "copy its elements or members separately");
    copy_cells(to.place, from.place, to.type, where, body);
}

void Reader::copy_cells(Program::Place to, Program::Place from, Id<Type> of, Span where, Program::Body& body) {
    const Type type = program.types[of];
    if (type.kind == Type::Kind::Array) {
        const std::uint32_t stride = size_of(program, type.element);
        for (std::int64_t index = type.low; index <= type.high; ++index) {
            copy_cells(to, from, type.element, where, body);
            to.offset += stride;
            from.offset += stride;
        }
        return;
    }
    if (type.kind == Type::Kind::Block) {
        for (std::size_t i = 0; i < program.units[type.unit].variables.size(); ++i) {
            const Variable& member = program.units[type.unit].variables[i];
            copy_cells(shifted(to, member.offset), shifted(from, member.offset), member.type, where, body);
        }
        return;
    }
    const Id<Node> node = add(Program::Op::Read, of, {}, where);
    program.nodes[node].place = std::move(from);
    Statement made;
    made.kind = Kind::Assign;
    made.place = std::move(to);
    made.type = of;
    made.value = node;
    made.origin = where;
    body.push_back(program.statements.add(std::move(made)));
}

void Reader::assign(const Found& cell, const Typed& value, Span where, Program::Body& body) {
    const std::string_view name = cell.variable->name;
    if (file_->dialect == st::Dialect::Codesys && st::capitals(name) == "SFCINIT")
        return reject(where, "an assignment to `SFCInit`", "use `SFCReset`");
    const auto node = converted(value, cell.type, where, "the value");
    if (!node) return;
    if (cell.instance) {  // the preset time limits the elapsed time of a timer
        const Unit& block = program.units[cell.block];
        if (block.elapsed && st::capitals(cell.variable->name) == "PT") {
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
                                                             "an integer, a bit string or an enumeration",
                                                             described(*selector)));
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
    if (values.front() > values.back())
        return reject(from.where, "an empty range of labels", "write the smaller label first");
    arm.labels.emplace_back(values.front(), values.back());
}

void Reader::for_statement(const st::Statement& from, Program::Body& body) {
    Statement made;
    made.kind = Kind::For;
    made.origin = from.where;
    const auto cell = target(from.target);
    if (cell && (program.types[cell->type].element.valid() || !cell->place.indices.empty()))
        return reject(file_->exprs[from.target].where, "a FOR variable of a subrange type, or with a variable index,",
                      "use an integer variable without a subrange, and only constants as indices");
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
            reject(where, "this step of FOR", "use a nonzero step in the range of DINT");
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
