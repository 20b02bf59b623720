// SPDX-License-Identifier: MIT
#include "run/program/interpreter.hpp"

#include <algorithm>
#include <bit>

namespace grafverif {

namespace {

using Op = Program::Op;
using Kind = Program::Statement::Kind;

}  // namespace

ProgramRun::ProgramRun(const Program& program) : program_(&program), layout_(layout_of(program)) {
    for (const ProgramCell& cell : layout_.cells) memory_.push_back(cell.initial);
}

void ProgramRun::scan(std::span<const std::int64_t> inputs, std::int64_t elapsed_ms, ScanLog* log) {
    overflowed_ = false;
    log_ = log;
    std::size_t next = 0;
    for (std::size_t i = 0; i < layout_.cells.size(); ++i)
        if (layout_.cells[i].input) memory_[i] = inputs[next++];
    for (const ProgramTimer& timer : layout_.timers)
        if (memory_[timer.running] != 0)
            memory_[timer.elapsed] = std::min(memory_[timer.elapsed] + elapsed_ms, timer.longest);
    invoke(program_->main, layout_.main);
    log_ = nullptr;
}

void ProgramRun::invoke(Id<Program::Unit> id, std::size_t frame) {
    const Program::Unit& unit = program_->units[id];
    for (const Program::Variable& variable : unit.variables)
        if (variable.section == Program::Variable::Section::Temporary)
            std::ranges::copy(initial_cells(*program_, variable),
                              memory_.begin() + static_cast<std::ptrdiff_t>(frame + variable.offset));
    execute(unit.body, frame);
}

// -- statements -------------------------------------------------------------------------------------------------------

ProgramRun::Flow ProgramRun::execute(const Program::Body& body, std::size_t frame) {
    for (const Id<Program::Statement> one : body) {
        const Flow flow = execute(one, frame);
        if (flow != Flow::Next || fault_) return flow;
    }
    return Flow::Next;
}

void ProgramRun::note(Id<Program::Statement> statement, std::size_t frame, std::int64_t value) {
    if (log_ != nullptr) log_->statements.push_back({statement, frame, value});
}

ProgramRun::Flow ProgramRun::execute(Id<Program::Statement> id, std::size_t frame) {
    const Program::Statement& statement = program_->statements[id];
    switch (statement.kind) {
    case Kind::Assign: {
        const std::int64_t value = evaluate(statement.value, frame);
        const std::size_t target = address(statement.place, frame, statement.origin);
        if (fault_) return Flow::Next;
        memory_[target] = value;
        note(id, frame, value);
        return Flow::Next;
    }
    case Kind::Invoke: {
        const std::size_t target = address(statement.place, frame, statement.origin);
        if (fault_) return Flow::Next;
        note(id, frame, 1);
        invoke(statement.unit, target);
        return Flow::Next;
    }
    case Kind::If:
    case Kind::Case: {
        const Program::Arm* arm = chosen(statement, frame);
        return arm == nullptr || fault_ ? Flow::Next : execute(arm->body, frame);
    }
    case Kind::For:
    case Kind::While:
    case Kind::Repeat: return loop(id, frame);
    case Kind::Check:
        if (evaluate(statement.value, frame) != 0) fail(statement.origin, ProgramFault::Chart);
        return Flow::Next;
    case Kind::Exit: note(id, frame, 1); return Flow::Exit;
    case Kind::Return: note(id, frame, 1); return Flow::Return;
    }
    return Flow::Next;
}

const Program::Arm* ProgramRun::chosen(const Program::Statement& statement, std::size_t frame) {
    const bool selects = statement.kind == Kind::Case;
    const std::int64_t selector = selects ? decision(statement.value, frame) : 0;
    for (const Program::Arm& arm : statement.arms) {
        const bool otherwise = !arm.condition.valid() && arm.labels.empty();
        const bool matches =
            selects ? std::ranges::any_of(
                          arm.labels,
                          [&](const auto& label) { return label.first <= selector && selector <= label.second; })
                    : !otherwise && decision(arm.condition, frame) != 0;
        if (otherwise || matches) return &arm;
    }
    return nullptr;
}

ProgramRun::Flow ProgramRun::loop(Id<Program::Statement> id, std::size_t frame) {
    const Program::Statement& statement = program_->statements[id];
    const Program::Body& body = statement.arms.front().body;
    std::int64_t last = 0;
    if (statement.kind == Kind::For) {
        const std::int64_t first = evaluate(statement.value, frame);
        last = evaluate(statement.last, frame);
        cell(statement.place, frame, statement.origin) = first;
    }
    while (!fault_) {
        if (statement.kind == Kind::While && decision(statement.value, frame) == 0) break;
        if (statement.kind == Kind::For) {
            const std::int64_t now = cell(statement.place, frame, statement.origin);
            if (statement.step > 0 ? now > last : now < last) break;
            note(id, frame, now);
        }
        const Flow flow = execute(body, frame);
        if (flow == Flow::Return) return flow;
        if (flow == Flow::Exit || fault_) break;
        if (statement.kind == Kind::Repeat && decision(statement.value, frame) != 0) break;
        if (statement.kind == Kind::For) {
            std::int64_t& variable = cell(statement.place, frame, statement.origin);
            variable = wrapped(program_->types[statement.type], variable + statement.step);
        }
    }
    return Flow::Next;
}

// -- expressions ------------------------------------------------------------------------------------------------------

/// Returns the address of a cell. An index outside its bounds is a fault; in this case, the address is computed with
/// the lowest index.
std::size_t ProgramRun::address(const Program::Place& place, std::size_t frame, Span origin) {
    std::size_t found = place.global ? place.offset : frame + place.offset;
    for (const Program::Index& index : place.indices) {
        const std::int64_t value = evaluate(index.value, frame);
        if (value < index.low || value > index.high) fail(origin, ProgramFault::ArrayBounds);
        else found += static_cast<std::size_t>(value - index.low) * index.stride;
    }
    return found;
}

std::int64_t ProgramRun::evaluate(Id<Program::Node> id, std::size_t frame) {
    const Program::Node& node = program_->nodes[id];
    if (node.op == Op::Constant) return node.value;
    if (node.op == Op::Read) {
        const std::int64_t value = cell(node.place, frame, node.origin);
        if (log_ != nullptr) log_->nodes.push_back({id, frame, value});
        return value;
    }
    if (node.op == Op::Call) return call(node, frame);
    if (node.op == Op::AndThen || node.op == Op::OrElse) {
        const bool first = evaluate(node.operands[0], frame) != 0;
        if (fault_ || first == (node.op == Op::OrElse)) return first ? 1 : 0;
        return evaluate(node.operands[1], frame);
    }
    std::vector<std::int64_t> values;
    for (const Id<Program::Node> operand : node.operands) values.push_back(evaluate(operand, frame));
    const auto is_true = [](std::int64_t value) { return value != 0; };
    if (program_->types[node.type].kind == Program::Type::Kind::Bits && node.op != Op::Select && node.op != Op::Convert)
        return bitwise(node, values);
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

/// Evaluates the condition or selector of a statement, and logs its value. If the condition is a variable, its value is
/// not logged twice, because reading the variable has already logged it.
std::int64_t ProgramRun::decision(Id<Program::Node> id, std::size_t frame) {
    const std::int64_t value = evaluate(id, frame);
    if (log_ != nullptr && program_->nodes[id].op != Op::Read) log_->nodes.push_back({id, frame, value});
    return value;
}

/// Returns the value of an operation on bit strings.
std::int64_t ProgramRun::bitwise(const Program::Node& node, const std::vector<std::int64_t>& values) const {
    const auto mask = static_cast<std::uint64_t>(program_->types[node.type].high);
    const auto width = static_cast<std::uint64_t>(std::popcount(mask));
    auto value = static_cast<std::uint64_t>(values[0]);
    const std::uint64_t places = values.size() > 1 ? static_cast<std::uint64_t>(values[1]) : 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const auto other = static_cast<std::uint64_t>(values[i]);
        if (node.op == Op::And) value &= other;
        if (node.op == Op::Or) value |= other;
        if (node.op == Op::Xor) value ^= other;
    }
    switch (node.op) {
    case Op::Not: value = ~value; break;
    case Op::ShiftLeft: value <<= places; break;
    case Op::ShiftRight: value >>= places; break;
    case Op::RotateLeft: value = (value << places) | (value >> (width - places)); break;
    case Op::RotateRight: value = (value >> places) | (value << (width - places)); break;
    default: break;
    }
    return static_cast<std::int64_t>(value & mask);
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
    case Op::Narrow:
        if (wrapped(program_->types[node.type], left) != left) fail(node.origin, ProgramFault::Range);
        return wrapped(program_->types[node.type], left);
    case Op::Divide:
    case Op::Modulo:
        if (right == 0) {
            fail(node.origin, ProgramFault::DivisionByZero);
            return 0;
        }
        return in_range(node, node.op == Op::Divide ? left / right : left % right);
    default: return left;
    }
}

std::int64_t ProgramRun::in_range(const Program::Node& node, std::int64_t value) {
    const Program::Type& type = program_->types[node.type];
    const std::int64_t kept = wrapped(type, value);
    if (kept != value && type.kind == Program::Type::Kind::Time) fail(node.origin, ProgramFault::Range);
    else overflowed_ = overflowed_ || kept != value;
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
