// SPDX-License-Identifier: MIT
#include "run/program/interpreter.hpp"

#include <algorithm>

namespace grafverif {

namespace {

using Op = Program::Op;
using Kind = Program::Statement::Kind;

}  // namespace

ProgramRun::ProgramRun(const Program& program) : program_(&program), layout_(layout_of(program)) {
    for (const ProgramCell& cell : layout_.cells) memory_.push_back(cell.initial);
}

void ProgramRun::scan(std::span<const std::int64_t> inputs, std::int64_t elapsed_ms) {
    overflowed_ = false;
    std::size_t next = 0;
    for (std::size_t i = 0; i < layout_.cells.size(); ++i)
        if (layout_.cells[i].input) memory_[i] = inputs[next++];
    for (const ProgramTimer& timer : layout_.timers)
        if (memory_[timer.running] != 0)
            memory_[timer.elapsed] = std::min(memory_[timer.elapsed] + elapsed_ms, timer.longest);
    invoke(program_->main, layout_.main);
}

void ProgramRun::invoke(Id<Program::Unit> id, std::size_t frame) {
    const Program::Unit& unit = program_->units[id];
    for (const Program::Variable& variable : unit.variables)
        if (variable.section == Program::Variable::Section::Temporary)
            memory_[frame + variable.offset] = variable.initial;
    execute(unit.body, frame);
}

// -- statements -------------------------------------------------------------------------------------------------------

ProgramRun::Flow ProgramRun::execute(const Program::Body& body, std::size_t frame) {
    for (const Id<Program::Statement> one : body) {
        const Flow flow = execute(program_->statements[one], frame);
        if (flow != Flow::Next || fault_) return flow;
    }
    return Flow::Next;
}

ProgramRun::Flow ProgramRun::execute(const Program::Statement& statement, std::size_t frame) {
    switch (statement.kind) {
    case Kind::Assign: {
        const std::int64_t value = evaluate(statement.value, frame);
        cell(statement.place, frame) = value;
        return Flow::Next;
    }
    case Kind::Invoke:
        invoke(statement.unit, statement.place.global ? statement.place.offset : frame + statement.place.offset);
        return Flow::Next;
    case Kind::If:
    case Kind::Case: {
        const Program::Arm* arm = chosen(statement, frame);
        return arm == nullptr || fault_ ? Flow::Next : execute(arm->body, frame);
    }
    case Kind::For:
    case Kind::While:
    case Kind::Repeat: return loop(statement, frame);
    case Kind::Exit: return Flow::Exit;
    case Kind::Return: return Flow::Return;
    }
    return Flow::Next;
}

const Program::Arm* ProgramRun::chosen(const Program::Statement& statement, std::size_t frame) {
    const bool selects = statement.kind == Kind::Case;
    const std::int64_t selector = selects ? evaluate(statement.value, frame) : 0;
    for (const Program::Arm& arm : statement.arms) {
        const bool otherwise = !arm.condition.valid() && arm.labels.empty();
        const bool matches =
            selects ? std::ranges::any_of(
                          arm.labels,
                          [&](const auto& label) { return label.first <= selector && selector <= label.second; })
                    : !otherwise && evaluate(arm.condition, frame) != 0;
        if (otherwise || matches) return &arm;
    }
    return nullptr;
}

ProgramRun::Flow ProgramRun::loop(const Program::Statement& statement, std::size_t frame) {
    const Program::Body& body = statement.arms.front().body;
    std::int64_t last = 0;
    if (statement.kind == Kind::For) {
        const std::int64_t first = evaluate(statement.value, frame);
        last = evaluate(statement.last, frame);
        cell(statement.place, frame) = first;
    }
    while (!fault_) {
        if (statement.kind == Kind::While && evaluate(statement.value, frame) == 0) break;
        if (statement.kind == Kind::For) {
            const std::int64_t now = cell(statement.place, frame);
            if (statement.step > 0 ? now > last : now < last) break;
        }
        const Flow flow = execute(body, frame);
        if (flow == Flow::Return) return flow;
        if (flow == Flow::Exit || fault_) break;
        if (statement.kind == Kind::Repeat && evaluate(statement.value, frame) != 0) break;
        if (statement.kind == Kind::For) {
            std::int64_t& variable = cell(statement.place, frame);
            variable = wrapped(program_->types[statement.type], variable + statement.step);
        }
    }
    return Flow::Next;
}

// -- expressions ------------------------------------------------------------------------------------------------------

std::int64_t ProgramRun::evaluate(Id<Program::Node> id, std::size_t frame) {
    const Program::Node& node = program_->nodes[id];
    if (node.op == Op::Constant) return node.value;
    if (node.op == Op::Read) return cell(node.place, frame);
    if (node.op == Op::Call) return call(node, frame);
    std::vector<std::int64_t> values;
    for (const Id<Program::Node> operand : node.operands) values.push_back(evaluate(operand, frame));
    const auto is_true = [](std::int64_t value) { return value != 0; };
    switch (node.op) {
    case Op::And: return std::ranges::all_of(values, is_true) ? 1 : 0;
    case Op::Or: return std::ranges::any_of(values, is_true) ? 1 : 0;
    case Op::Xor: return std::ranges::count_if(values, is_true) % 2;
    case Op::Minimum: return std::ranges::min(values);
    case Op::Maximum: return std::ranges::max(values);
    case Op::Limit: return std::min(std::max(values[1], values[0]), values[2]);
    case Op::Select: return values[0] != 0 ? values[2] : values[1];
    default: return calculated(node, values[0], values.size() > 1 ? values[1] : 0);
    }
}

std::int64_t ProgramRun::calculated(const Program::Node& node, std::int64_t left, std::int64_t right) {
    switch (node.op) {
    case Op::Not: return left == 0 ? 1 : 0;
    case Op::Equal: return left == right ? 1 : 0;
    case Op::NotEqual: return left != right ? 1 : 0;
    case Op::Less: return left < right ? 1 : 0;
    case Op::LessEqual: return left <= right ? 1 : 0;
    case Op::Greater: return left > right ? 1 : 0;
    case Op::GreaterEqual: return left >= right ? 1 : 0;
    case Op::Negate: return in_range(node, -left);
    case Op::Plus: return in_range(node, left + right);
    case Op::Minus: return in_range(node, left - right);
    case Op::Times: return in_range(node, left * right);
    case Op::Absolute: return in_range(node, left < 0 ? -left : left);
    case Op::IsNonzero: return left != 0 ? 1 : 0;
    case Op::Convert: return wrapped(program_->types[node.type], left);
    case Op::Divide:
    case Op::Modulo:
        if (right == 0) {
            if (!fault_) fault_ = node.origin;
            return 0;
        }
        return in_range(node, node.op == Op::Divide ? left / right : left % right);
    default: return left;
    }
}

std::int64_t ProgramRun::in_range(const Program::Node& node, std::int64_t value) {
    const std::int64_t kept = wrapped(program_->types[node.type], value);
    overflowed_ = overflowed_ || kept != value;
    return kept;
}

std::int64_t ProgramRun::call(const Program::Node& node, std::size_t frame) {
    std::vector<std::int64_t> values;
    for (const Id<Program::Node> operand : node.operands) values.push_back(evaluate(operand, frame));
    const Program::Unit& unit = program_->units[node.unit];
    const std::size_t own = memory_.size();
    for (const std::int64_t value : initial_frame(*program_, node.unit)) memory_.push_back(value);
    for (std::size_t i = 0; i < values.size(); ++i) memory_[own + unit.inputs[i]] = values[i];
    if (!fault_) execute(unit.body, own);
    const std::int64_t result = memory_[own + *unit.result];
    memory_.resize(own);
    return result;
}

}  // namespace grafverif
