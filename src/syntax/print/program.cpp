// SPDX-License-Identifier: MIT
#include "syntax/print/program.hpp"

#include <string_view>
#include <vector>

#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

using ProgramOp = Program::Op;

class ProgramPrinter {
public:
    /// If `block` is valid, a place in an instance of this function block is printed as the name of the instance.
    ProgramPrinter(const Program& program, Id<Program::Unit> unit, Id<Program::Unit> block = {})
        : program_(program), unit_(unit), block_(block) {}

    std::string place(const Program::Place& place) const {
        if (!place.global) return member(unit_, place.offset, place.indices);
        const std::uint32_t globals = program_.units[program_.globals].size;
        if (place.offset < globals) return member(program_.globals, place.offset, place.indices);
        return member(program_.main, place.offset - globals, place.indices);
    }

    std::string term(Id<Program::Node> id, bool inner = false) const {
        const Program::Node& node = program_.nodes[id];
        if (node.op == ProgramOp::Constant) return constant(node);
        if (node.op == ProgramOp::Read) return place(node.place);
        const std::string_view symbol = infix(node.op);
        if (symbol.empty() || node.operands.size() < 2) return prefixed(node);
        std::string text;
        for (const Id<Program::Node> operand : node.operands)
            text += (text.empty() ? "" : " " + std::string(symbol) + " ") + term(operand, true);
        return inner ? "(" + text + ")" : text;
    }

private:
    /// Returns the name of the memory cell at `offset` in a frame (memory of an instance) of `unit`. `indices` contains
    /// the array indices that are not constant.
    std::string member(Id<Program::Unit> unit, std::uint32_t offset, std::vector<Program::Index> indices) const {
        for (const Program::Variable& variable : program_.units[unit].variables) {
            const std::uint32_t size = size_of(program_, variable.type);
            if (offset >= variable.offset && offset < variable.offset + size)
                return variable.name + rest(variable.type, offset - variable.offset, std::move(indices));
        }
        return {};
    }

    std::string rest(Id<Program::Type> of, std::uint32_t offset, std::vector<Program::Index> indices) const {
        const Program::Type& type = program_.types[of];
        if (block_.valid() && type.unit == block_ && offset == 0) return {};
        if (type.kind == Program::Type::Kind::Block) return "." + member(type.unit, offset, std::move(indices));
        if (type.kind != Program::Type::Kind::Array) return {};
        const std::uint32_t stride = size_of(program_, type.element);
        std::string index = std::to_string(type.low + offset / stride);
        if (!indices.empty() && indices.front().stride == stride && indices.front().low == type.low) {
            index = term(indices.front().value);
            indices.erase(indices.begin());
        }
        return "[" + index + "]" + rest(type.element, offset % stride, std::move(indices));
    }

    std::string constant(const Program::Node& node) const {
        const Program::Type& type = program_.types[node.type];
        switch (type.kind) {
        case Program::Type::Kind::Boolean: return node.value != 0 ? "TRUE" : "FALSE";
        case Program::Type::Kind::Time: return "T#" + duration_text(node.value);
        case Program::Type::Kind::Enumeration:
            if (node.value >= 0 && static_cast<std::size_t>(node.value) < type.values.size())
                return type.values[static_cast<std::size_t>(node.value)];
            break;
        default: break;
        }
        return std::to_string(node.value);
    }

    std::string prefixed(const Program::Node& node) const {
        std::string operands;
        for (const Id<Program::Node> operand : node.operands)
            operands += (operands.empty() ? "" : ", ") + term(operand);
        const auto first = [&] { return term(node.operands.front(), true); };
        switch (node.op) {
        case ProgramOp::Not: return "NOT " + first();
        case ProgramOp::Negate: return "-" + first();
        case ProgramOp::IsNonzero: return first() + " <> 0";
        case ProgramOp::Narrow: return first();
        case ProgramOp::Convert: return "TO_" + program_.types[node.type].name + "(" + operands + ")";
        case ProgramOp::Call: return program_.units[node.unit].name + "(" + operands + ")";
        default: return std::string(function(node.op)) + "(" + operands + ")";
        }
    }

    static std::string_view infix(ProgramOp op) {
        switch (op) {
        case ProgramOp::And: return "AND";
        case ProgramOp::Or: return "OR";
        case ProgramOp::Xor: return "XOR";
        case ProgramOp::AndThen: return "AND_THEN";
        case ProgramOp::OrElse: return "OR_ELSE";
        case ProgramOp::Equal: return "=";
        case ProgramOp::NotEqual: return "<>";
        case ProgramOp::Less: return "<";
        case ProgramOp::LessEqual: return "<=";
        case ProgramOp::Greater: return ">";
        case ProgramOp::GreaterEqual: return ">=";
        case ProgramOp::Plus: return "+";
        case ProgramOp::Minus: return "-";
        case ProgramOp::Times: return "*";
        case ProgramOp::Divide: return "/";
        case ProgramOp::Modulo: return "MOD";
        default: return {};
        }
    }

    static std::string_view function(ProgramOp op) {
        switch (op) {
        case ProgramOp::ShiftLeft: return "SHL";
        case ProgramOp::ShiftRight: return "SHR";
        case ProgramOp::RotateLeft: return "ROL";
        case ProgramOp::RotateRight: return "ROR";
        case ProgramOp::Absolute: return "ABS";
        case ProgramOp::Minimum: return "MIN";
        case ProgramOp::Maximum: return "MAX";
        case ProgramOp::Limit: return "LIMIT";
        case ProgramOp::Select: return "SEL";
        default: return infix(op);
        }
    }

    const Program& program_;
    Id<Program::Unit> unit_, block_;
};

}  // namespace

std::string place_text(const Program& program, Id<Program::Unit> unit, const Program::Place& place) {
    return ProgramPrinter(program, unit).place(place);
}

std::string instance_text(const Program& program, Id<Program::Unit> unit, const Program::Place& place,
                          Id<Program::Unit> block) {
    return ProgramPrinter(program, unit, block).place(place);
}

std::string term_text(const Program& program, Id<Program::Unit> unit, Id<Program::Node> term) {
    return ProgramPrinter(program, unit).term(term);
}

std::string statement_text(const Program& program, Id<Program::Unit> unit, const Program::Statement& statement) {
    using Kind = Program::Statement::Kind;
    if (statement.kind == Kind::Assign)
        return place_text(program, unit, statement.place) + " := " + term_text(program, unit, statement.value);
    if (statement.kind != Kind::Invoke) return statement.kind == Kind::Exit ? "EXIT" : "RETURN";
    const Program::Unit& called = program.units[statement.unit];
    if (!called.owner.valid()) return instance_text(program, unit, statement.place, statement.unit) + "()";
    if (called.owner == unit) return called.name + "()";
    return instance_text(program, unit, statement.place, called.owner) + "." + called.name + "()";
}

}  // namespace grafverif
