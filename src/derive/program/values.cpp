// SPDX-License-Identifier: MIT
// Evaluates expressions. Values outside the range of a type wrap around. A value wraps around by adding or subtracting
// the number of values of its type. The operation and the ranges of its operands determine whether adding or
// subtracting once is sufficient.
#include <algorithm>
#include <bit>

#include "derive/program/execution.hpp"
#include "ir/literal.hpp"
#include "support/messages_program.hpp"

namespace grafverif {

namespace {

using Operation = Program::Op;

}  // namespace

Id<Expr> SymbolicExecution::value(Id<Program::Node> id, std::uint32_t frame) {
    const Program::Node& node = program_.nodes[id];
    switch (node.op) {
    case Operation::Constant:
        return program_.types[node.type].kind == Program::Type::Kind::Boolean ? exprs_.constant(node.value != 0)
                                                                              : exprs_.integer(node.value);
    case Operation::Read: return read(node, frame);
    case Operation::Call: return call(node, frame);
    case Operation::AndThen:
    case Operation::OrElse: return lazy(node, frame);
    default: break;
    }
    std::vector<Id<Expr>> values;
    for (const Id<Program::Node> operand : node.operands) values.push_back(value(operand, frame));
    const bool bits = program_.types[node.type].kind == Program::Type::Kind::Bits;
    if (bits && node.op != Operation::Select && node.op != Operation::Convert) return bitwise(node, values);
    return calculated(node, values);
}

// -- array elements ---------------------------------------------------------------------------------------------------

std::vector<SymbolicExecution::Element> SymbolicExecution::elements(const Program::Place& place, std::uint32_t frame,
                                                                    Span origin) {
    std::vector<Element> found = {{address(place, frame), exprs_.constant(true)}};
    for (const Program::Index& index : place.indices) {
        const Id<Expr> at = value(index.value, frame);
        const Id<Expr> outside = exprs_.disjunction(exprs_.apply(Op::Less, at, exprs_.integer(index.low)),
                                                    exprs_.apply(Op::Greater, at, exprs_.integer(index.high)));
        event(faults, outside, origin, ProgramFault::ArrayBounds);
        std::vector<Element> next;
        for (const Element& one : found)
            for (std::int64_t i = index.low; i <= index.high; ++i) {
                const Id<Expr> condition =
                    exprs_.conjunction(one.condition, exprs_.apply(Op::Equal, at, exprs_.integer(i)));
                if (is_false(exprs_, condition)) continue;
                next.push_back({one.cell + static_cast<std::uint32_t>(i - index.low) * index.stride, condition});
            }
        found = std::move(next);
    }
    return found;
}

/// Returns the value of a variable or array element. An index outside the array is a fault; after this fault, the value
/// is arbitrary.
Id<Expr> SymbolicExecution::read(const Program::Node& node, std::uint32_t frame) {
    if (node.place.indices.empty()) {
        note_read(address(node.place, frame));
        return memory_[address(node.place, frame)];
    }
    const std::vector<Element> all = elements(node.place, frame, node.origin);
    for (const Element& one : all) note_read(one.cell);
    Id<Expr> result = memory_[all.empty() ? address(node.place, frame) : all.back().cell];
    for (std::size_t i = all.size(); i-- > 1;)
        result = exprs_.conditional(all[i - 1].condition, memory_[all[i - 1].cell], result);
    return result;
}

/// Evaluates AND_THEN and OR_ELSE. The second operand is evaluated in a branch, so that its faults and overflows occur
/// only if the first operand does not determine the result.
Id<Expr> SymbolicExecution::lazy(const Program::Node& node, std::uint32_t frame) {
    const Id<Expr> first = value(node.operands[0], frame);
    const bool conjunction = node.op == Operation::AndThen;
    branch(
        conjunction ? first : exprs_.negation(first),
        [&] {
            const Id<Expr> second = value(node.operands[1], frame);
            write(value_, second);
        },
        [&] { write(value_, exprs_.constant(!conjunction)); });
    return memory_[value_];
}

// -- bit strings ------------------------------------------------------------------------------------------------------

/// Returns a term that is true if bit `place` of a non-negative number is set.
Id<Expr> SymbolicExecution::bit(Id<Expr> value, std::int64_t place) {
    const Id<Expr> shifted =
        place == 0 ? value : exprs_.apply(Op::Divide, value, exprs_.integer(std::int64_t{1} << place));
    return exprs_.apply(Op::Equal, exprs_.apply(Op::Modulo, shifted, exprs_.integer(2)), exprs_.integer(1));
}

Id<Expr> SymbolicExecution::bitwise(const Program::Node& node, const std::vector<Id<Expr>>& values) {
    const std::int64_t high = program_.types[node.type].high;
    const auto width = static_cast<std::int64_t>(std::popcount(static_cast<std::uint64_t>(high)));
    const auto power = [&](std::int64_t places) { return exprs_.integer(std::int64_t{1} << places); };
    const auto lower = [&](std::int64_t places) {  // returns the number that consists of the lowest `places` bits
        return places == width ? values[0] : exprs_.apply(Op::Modulo, values[0], power(places));
    };
    const auto upper = [&](std::int64_t places) {  // returns the number without its lowest `places` bits
        return places == 0 ? values[0] : exprs_.apply(Op::Divide, values[0], power(places));
    };
    switch (node.op) {
    case Operation::Not: return exprs_.apply(Op::Minus, exprs_.integer(high), values[0]);
    case Operation::And:
    case Operation::Or:
    case Operation::Xor: break;
    default: {
        const std::int64_t places = program_.nodes[node.operands[1]].value;
        if (places == 0) return values[0];
        const bool left = node.op == Operation::ShiftLeft || node.op == Operation::RotateLeft;
        const bool rotates = node.op == Operation::RotateLeft || node.op == Operation::RotateRight;
        if (places == width) return rotates ? values[0] : exprs_.integer(0);
        const std::int64_t cut = left ? width - places : places;
        if (!left && !rotates) return upper(cut);
        const Id<Expr> moved = exprs_.apply(Op::Times, lower(cut), power(width - cut));
        return rotates ? exprs_.apply(Op::Plus, moved, upper(cut)) : moved;
    }
    }
    Id<Expr> sum = exprs_.integer(0);
    for (std::int64_t place = 0; place < width; ++place) {
        std::vector<Id<Expr>> bits;
        for (const Id<Expr> one : values) bits.push_back(bit(one, place));
        Id<Expr> set = bits[0];
        if (node.op == Operation::And) set = exprs_.conjunction(bits);
        else if (node.op == Operation::Or) set = exprs_.disjunction(bits);
        else
            for (std::size_t i = 1; i < bits.size(); ++i) set = exprs_.apply(Op::NotEqual, set, bits[i]);
        if (!is_false(exprs_, set))
            sum = exprs_.apply(Op::Plus, sum, exprs_.conditional(set, power(place), exprs_.integer(0)));
    }
    return sum;
}

Id<Expr> SymbolicExecution::calculated(const Program::Node& node, const std::vector<Id<Expr>>& values) {
    const auto compared = [&](Op op) { return exprs_.apply(op, values[0], values[1]); };
    const auto chosen = [&](Op op) {
        Id<Expr> best = values[0];
        for (std::size_t i = 1; i < values.size(); ++i)
            best = exprs_.conditional(exprs_.apply(op, values[i], best), values[i], best);
        return best;
    };
    switch (node.op) {
    case Operation::Not: return exprs_.negation(values[0]);
    case Operation::And: return exprs_.conjunction(values);
    case Operation::Or: return exprs_.disjunction(values);
    case Operation::Xor: {
        Id<Expr> odd = values[0];
        for (std::size_t i = 1; i < values.size(); ++i) odd = exprs_.apply(Op::NotEqual, odd, values[i]);
        return odd;
    }
    case Operation::Equal: return compared(Op::Equal);
    case Operation::NotEqual: return compared(Op::NotEqual);
    case Operation::Less: return compared(Op::Less);
    case Operation::LessEqual: return compared(Op::LessEqual);
    case Operation::Greater: return compared(Op::Greater);
    case Operation::GreaterEqual: return compared(Op::GreaterEqual);
    case Operation::Negate: {
        const std::vector<Id<Expr>> one = {values[0]};
        return in_range(node, exprs_.apply(Op::Negate, one));
    }
    case Operation::Plus: return in_range(node, compared(Op::Plus));
    case Operation::Minus: return in_range(node, compared(Op::Minus));
    case Operation::Times: return in_range(node, compared(Op::Times));
    case Operation::Divide:
    case Operation::Modulo: return quotient(node, values[0], values[1]);
    case Operation::Absolute: {
        const std::vector<Id<Expr>> one = {values[0]};
        const Id<Expr> negative = exprs_.apply(Op::Less, values[0], exprs_.integer(0));
        return in_range(node, exprs_.conditional(negative, exprs_.apply(Op::Negate, one), values[0]));
    }
    case Operation::Minimum: return chosen(Op::Less);
    case Operation::Maximum: return chosen(Op::Greater);
    case Operation::Limit: {
        const Id<Expr> low = exprs_.conditional(exprs_.apply(Op::Less, values[1], values[0]), values[0], values[1]);
        return exprs_.conditional(exprs_.apply(Op::Greater, low, values[2]), values[2], low);
    }
    case Operation::Select: return exprs_.conditional(values[0], values[2], values[1]);
    case Operation::IsNonzero: return exprs_.apply(Op::NotEqual, values[0], exprs_.integer(0));
    case Operation::Narrow: {
        const Program::Type& to = program_.types[node.type];
        event(faults,
              exprs_.disjunction(exprs_.apply(Op::Less, values[0], exprs_.integer(to.low)),
                                 exprs_.apply(Op::Greater, values[0], exprs_.integer(to.high))),
              node.origin, ProgramFault::Range);
        return wrapped_term(to, values[0], false);
    }
    case Operation::Convert: {
        const Program::Type& from = program_.types[program_.nodes[node.operands[0]].type];
        const Program::Type& to = program_.types[node.type];
        if (from.kind == Program::Type::Kind::Boolean)
            return exprs_.conditional(values[0], exprs_.integer(1), exprs_.integer(0));
        const std::int64_t count = to.high - to.low + 1;
        const bool once = from.high <= to.high + count && from.low >= to.low - count;
        return from.low >= to.low && from.high <= to.high ? values[0] : wrapped_term(to, values[0], once);
    }
    case Operation::Constant:
    case Operation::Read:
    case Operation::AndThen:
    case Operation::OrElse:
    case Operation::ShiftLeft:
    case Operation::ShiftRight:
    case Operation::RotateLeft:
    case Operation::RotateRight:
    case Operation::Call: break;
    }
    return values[0];
}

/// Returns the quotient or remainder. If the divisor is zero, a fault is recorded and the value is arbitrary.
Id<Expr> SymbolicExecution::quotient(const Program::Node& node, Id<Expr> left, Id<Expr> right) {
    const Id<Expr> zero = exprs_.apply(Op::Equal, right, exprs_.integer(0));
    event(faults, zero, node.origin);
    const Id<Expr> divisor = exprs_.conditional(zero, exprs_.integer(1), right);
    return in_range(node, exprs_.apply(node.op == Operation::Divide ? Op::Divide : Op::Modulo, left, divisor));
}

Id<Expr> SymbolicExecution::in_range(const Program::Node& node, Id<Expr> value) {
    if (node.op == Operation::Modulo) return value;
    const Program::Type& type = program_.types[node.type];
    const Id<Expr> high = exprs_.integer(type.high), low = exprs_.integer(type.low);
    const bool time = type.kind == Program::Type::Kind::Time;
    const bool only_up = !time && (node.op == Operation::Absolute || node.op == Operation::Divide);
    const Id<Expr> above = exprs_.apply(Op::Greater, value, high);
    const Id<Expr> below = only_up ? exprs_.constant(false) : exprs_.apply(Op::Less, value, low);
    if ((only_up && type.low == 0) || (is_false(exprs_, above) && is_false(exprs_, below))) return value;
    event(time ? faults : overflows, exprs_.disjunction(above, below), node.origin, ProgramFault::Range);
    if (only_up) {  // only the negated minimum of the type is outside of the range
        const std::int64_t count = type.high - type.low + 1;
        return exprs_.conditional(above, exprs_.apply(Op::Minus, value, exprs_.integer(count)), value);
    }
    return wrapped_term(type, value, node.op != Operation::Times);
}

/// Returns the value of the type that is congruent to `value` modulo the number of values of the type. If `once` is
/// true, the caller guarantees that one addition or subtraction of this number is sufficient.
Id<Expr> SymbolicExecution::wrapped_term(const Program::Type& type, Id<Expr> value, bool once) {
    const Id<Expr> count = exprs_.integer(type.high - type.low + 1);
    if (once) {
        const Id<Expr> above = exprs_.apply(Op::Greater, value, exprs_.integer(type.high));
        const Id<Expr> below = exprs_.apply(Op::Less, value, exprs_.integer(type.low));
        return exprs_.conditional(above, exprs_.apply(Op::Minus, value, count),
                                  exprs_.conditional(below, exprs_.apply(Op::Plus, value, count), value));
    }
    const Id<Expr> rest = exprs_.apply(Op::Modulo, exprs_.apply(Op::Minus, value, exprs_.integer(type.low)), count);
    const Id<Expr> positive =
        exprs_.conditional(exprs_.apply(Op::Less, rest, exprs_.integer(0)), exprs_.apply(Op::Plus, rest, count), rest);
    return exprs_.apply(Op::Plus, positive, exprs_.integer(type.low));
}

void SymbolicExecution::initial_terms(Id<Program::Type> of, std::int64_t initial, std::vector<Id<Expr>>& terms) {
    const Program::Type& type = program_.types[of];
    if (type.kind == Program::Type::Kind::Array) {
        for (std::int64_t index = type.low; index <= type.high; ++index) initial_terms(type.element, initial, terms);
    } else if (type.kind == Program::Type::Kind::Block) {
        for (const Program::Variable& variable : program_.units[type.unit].variables)
            initial_terms(variable.type, variable.initial, terms);
    } else if (type.kind != Program::Type::Kind::Unsupported) {
        terms.push_back(
            literal(exprs_, type.kind == Program::Type::Kind::Boolean ? Type{} : integer_type(0, 1), initial));
    }
}

Id<Expr> SymbolicExecution::call(const Program::Node& node, std::uint32_t frame) {
    constexpr std::size_t most_calls = 1000;
    if (calls_ == most_calls) fail(messages::program_too_large(node.origin, "nested calls", most_calls));
    const bool boolean = program_.types[node.type].kind == Program::Type::Kind::Boolean;
    if (failed_) return boolean ? exprs_.constant(false) : exprs_.integer(0);
    ++calls_;
    std::vector<Id<Expr>> values;
    for (const Id<Program::Node> operand : node.operands) values.push_back(value(operand, frame));
    const Program::Unit& unit = program_.units[node.unit];
    const auto own = static_cast<std::uint32_t>(memory_.size());
    for (const Program::Variable& variable : unit.variables) initial_terms(variable.type, variable.initial, memory_);
    for (std::size_t i = 0; i < values.size(); ++i) memory_[own + unit.inputs[i]] = values[i];
    const Id<Expr> returned = memory_[returned_], exited = memory_[exited_];
    write(returned_, exprs_.constant(false));
    write(exited_, exprs_.constant(false));
    execute(unit.body, 0, own);
    write(returned_, returned);
    write(exited_, exited);
    const Id<Expr> result = memory_[own + *unit.result];
    memory_.resize(own);
    --calls_;
    return result;
}

}  // namespace grafverif
