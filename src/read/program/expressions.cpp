// SPDX-License-Identifier: MIT
// Reads expressions and determines their types. An integer literal gets the type of the other operands. If integer
// operands have different types, they are converted to the type whose range contains the ranges of the other types.
#include <algorithm>
#include <string>

#include "read/program/scope.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif::program {

namespace {

using Op = Program::Op;

Op op_of(st::Op op) {
    switch (op) {
    case st::Op::Not: return Op::Not;
    case st::Op::And: return Op::And;
    case st::Op::Or: return Op::Or;
    case st::Op::Xor: return Op::Xor;
    case st::Op::AndThen: return Op::AndThen;
    case st::Op::OrElse: return Op::OrElse;
    case st::Op::Equal: return Op::Equal;
    case st::Op::NotEqual: return Op::NotEqual;
    case st::Op::Less: return Op::Less;
    case st::Op::LessEqual: return Op::LessEqual;
    case st::Op::Greater: return Op::Greater;
    case st::Op::GreaterEqual: return Op::GreaterEqual;
    case st::Op::Negate: return Op::Negate;
    case st::Op::Plus: return Op::Plus;
    case st::Op::Minus: return Op::Minus;
    case st::Op::Times: return Op::Times;
    case st::Op::Divide: return Op::Divide;
    case st::Op::Modulo: return Op::Modulo;
    default: return Op::Constant;
    }
}

bool contains(const Type& outer, const Type& inner) { return outer.low <= inner.low && inner.high <= outer.high; }

}  // namespace

Id<Node> Reader::add(Op op, Id<Type> type, std::vector<Id<Node>> operands, Span where) {
    Node node;
    node.op = op;
    node.type = type;
    node.operands = std::move(operands);
    node.origin = where;
    return program.nodes.add(std::move(node));
}

Id<Node> Reader::number(std::int64_t value, Id<Type> type, Span where) {
    const Id<Node> id = add(Op::Constant, type, {}, where);
    program.nodes[id].value = value;
    return id;
}

std::optional<std::int64_t> Reader::value_of(Id<Node> node) const {
    if (program.nodes[node].op != Op::Constant) return {};
    return program.nodes[node].value;
}

std::string Reader::described(const Typed& value) const {
    return value.literal ? "a number" : "of type `" + type(value).name + "`";
}

std::optional<Id<Node>> Reader::converted(const Typed& value, Id<Type> to, Span where, std::string_view what) {
    const Type& from = type(value);
    const Type target = program.types[to];
    const auto known = value_of(value.node);
    if (target.kind == Type::Kind::Integer && target.element.valid() && !(value.literal && known)) {  // a subrange
        const auto whole = converted(value, target.element, where, what);
        if (!whole) return {};
        if (!known) return add(Op::Narrow, to, {*whole}, where);
        if (target.low <= *known && *known <= target.high) return number(*known, to, where);
        diagnostics->add(messages::not_a_number_of_type(where, *known, target.name));
        return {};
    }
    if (value.literal) {
        const std::int64_t number_value = *value_of(value.node);
        const bool fits = target.low <= number_value && number_value <= target.high;
        const bool boolean_bit = target.kind == Type::Kind::Boolean && fits;
        if (is_number(target) || target.kind == Type::Kind::Bits || boolean_bit) {
            if (fits) return number(number_value, to, where);
            diagnostics->add(messages::not_a_number_of_type(where, number_value, target.name));
            return {};
        }
    } else if (program.nodes[value.node].type == to) {
        return value.node;
    } else if (from.kind == target.kind && (is_number(target) || target.kind == Type::Kind::Bits) &&
               contains(target, from)) {
        if (known) return number(*known, to, where);
        return add(Op::Convert, to, {value.node}, where);
    }
    diagnostics->add(messages::program_type_mismatch(where, what, "`" + target.name + "`", described(value)));
    return {};
}

/// Converts all operands to one type. Returns false after an error.
bool Reader::unify(std::vector<Typed>& operands, Span where) {
    Id<Type> common;
    for (const Typed& operand : operands) {
        if (operand.literal) continue;
        const Id<Type> own = program.nodes[operand.node].type;
        const bool wider = common.valid() && program.types[own].kind == program.types[common].kind &&
                           (is_number(program.types[own]) || program.types[own].kind == Type::Kind::Bits) &&
                           contains(program.types[own], program.types[common]);
        if (!common.valid() || wider) common = own;
    }
    if (!common.valid()) return true;  // all operands are literals
    for (Typed& operand : operands) {
        const auto node = converted(operand, common, where, "an operand");
        if (!node) return false;
        operand = {*node, false};
    }
    return true;
}

Reader::MaybeTyped Reader::expression(Id<st::Expr> id) {
    switch (file_->exprs[id].op) {
    case st::Op::Not:
    case st::Op::And:
    case st::Op::Or:
    case st::Op::AndThen:
    case st::Op::OrElse:
    case st::Op::Xor: return junction(id);
    case st::Op::Equal:
    case st::Op::NotEqual:
    case st::Op::Less:
    case st::Op::LessEqual:
    case st::Op::Greater:
    case st::Op::GreaterEqual: return comparison(id);
    case st::Op::Negate:
    case st::Op::Plus:
    case st::Op::Minus:
    case st::Op::Times:
    case st::Op::Divide:
    case st::Op::Modulo: return arithmetic(id);
    case st::Op::Call: return call(id);
    default: return leaf(id);
    }
}

Reader::MaybeTyped Reader::leaf(Id<st::Expr> id) {
    const st::Expr& from = file_->exprs[id];
    switch (from.op) {
    case st::Op::False:
    case st::Op::True: return Typed{number(from.op == st::Op::True ? 1 : 0, bool_, from.where), false};
    case st::Op::Integer: return Typed{number(from.value, dint_, from.where), true};
    case st::Op::Time: return Typed{number(from.value, time_, from.where), false};
    case st::Op::Other: {
        const std::string written = text(from.word);
        const std::size_t hash = written.find('#');
        if (hash != std::string::npos) {
            const auto known = values_.find(file_->intern(written.substr(hash + 1)).index);
            const auto type = types_.find(file_->intern(written.substr(0, hash)).index);
            if (known != values_.end() && type != types_.end() && type->second == known->second.type) {
                record_.refer(last_name(from.where, written.substr(hash + 1)), known->second.origin);
                if (const auto declared = type_declarations_.find(file_->intern(written.substr(0, hash)).index);
                    declared != type_declarations_.end())
                    record_.refer(last_name({from.where.source, from.where.begin,
                                             from.where.end - static_cast<std::uint32_t>(written.size() - hash)},
                                            written.substr(0, hash)),
                                  file_->types[declared->second].name.where);
                return Typed{number(known->second.value, type->second, from.where), false};
            }
        }
        reject(from.where, "this literal", "use Boolean values, integers and durations");
        return {};
    }
    case st::Op::Name:
        if (const auto value = values_.find(from.word.index);
            value != values_.end() && !scopes_[unit_.index].variables.contains(from.word.index)) {
            refer(from, value->second.origin);
            return Typed{number(value->second.value, value->second.type, from.where), false};
        }
        [[fallthrough]];
    case st::Op::Member:
    case st::Op::Index:
    case st::Op::Dereference:
    case st::Op::Address: {
        const auto found = variable(id);
        return found ? value_at(*found, from.where) : std::nullopt;
    }
    case st::Op::Power: reject(from.where, "the operator `**`", "write a product"); return {};
    default: reject(from.where, "this expression", "use operators, variables and calls"); return {};
    }
}

/// Returns an expression for the value of a variable. The value of a variable with a subrange type has the base type.
Reader::MaybeTyped Reader::value_at(const Found& found, Span where) {
    const Type type = program.types[found.type];
    if (type.kind == Type::Kind::Block) {
        const bool structure = program.units[type.unit].kind == Unit::Kind::Structure;
        if (structure) reject(where, "a structure as a value", "assign the complete structure, or read its members");
        else reject(where, "a function block as a value", "read one of its outputs");
        return {};
    }
    if (type.kind == Type::Kind::Array)
        return reject(where, "an array as a value", "assign the complete array, or read its elements"), std::nullopt;
    if (type.kind == Type::Kind::Unsupported)
        return reject(where, "a variable of the type `" + type.name + "`",
                      "use BOOL, TIME or an integer of at most 32 bits"),
               std::nullopt;
    if (found.constant) return Typed{number(found.variable->initial, found.type, where), false};
    limit_step_time(found);
    const Id<Node> node = add(Op::Read, found.type, {}, where);
    program.nodes[node].place = found.place;
    return Typed{type.element.valid() ? add(Op::Convert, type.element, {node}, where) : node, false};
}

/// Converts an integer operand of a bitwise operator to a bit string of the same width. CODESYS permits integer
/// operands of bitwise operators; in other dialects, they are an error.
Reader::MaybeTyped Reader::as_bits(const Typed& value, Span where) {
    if (file_->dialect != st::Dialect::Codesys)
        return reject(where, "a bitwise operator with integer operands", "convert the operands to bit strings"),
               std::nullopt;
    warn_once("the type of a bitwise operation on integers",
              "integers are assumed to be converted to bit strings of their width", where);
    const std::int64_t count = type(value).high - type(value).low;
    const Id<Type> to = types_.at(file_->intern(count <= 255 ? "BYTE" : count <= 65535 ? "WORD" : "DWORD").index);
    return Typed{add(Op::Convert, to, {value.node}, where), false};
}

/// Resolves the operators of Boolean values and of bit strings.
Reader::MaybeTyped Reader::junction(Id<st::Expr> id) {
    const st::Expr from = file_->exprs[id];
    std::vector<Typed> values;
    bool ok = true;
    for (const Id<st::Expr> one : st::operands(*file_, id)) {
        auto value = expression(one);
        if (value && !value->literal && is_number(type(*value))) value = as_bits(*value, file_->exprs[one].where);
        if (value) values.push_back(*value);
        ok = ok && value;
    }
    if (!ok) return {};
    const bool lazy = from.op == st::Op::AndThen || from.op == st::Op::OrElse;
    const bool bits =
        !lazy && std::ranges::any_of(values, [&](const Typed& value) { return type(value).kind == Type::Kind::Bits; });
    if (bits && !unify(values, from.where)) return {};
    std::vector<Id<Node>> operands;
    for (const Typed& value : values) {
        const Id<Type> to = bits ? program.nodes[values.front().node].type : bool_;
        const auto node = converted(value, to, program.nodes[value.node].origin, "an operand");
        if (!node) return {};
        operands.push_back(*node);
    }
    const Id<Type> result = bits ? program.nodes[operands.front()].type : bool_;
    return Typed{add(op_of(from.op), result, std::move(operands), from.where), false};
}

Reader::MaybeTyped Reader::comparison(Id<st::Expr> id) {
    const st::Expr from = file_->exprs[id];
    const std::vector<Id<st::Expr>> parts = st::operands(*file_, id);
    if (parts.size() != 2) return {};  // the parser has reported the error
    const auto [left, right] = compared(parts);
    if (!left || !right) return {};
    std::vector<Typed> both = {*left, *right};
    if (!unify(both, from.where)) return {};
    const Type::Kind kind = type(both[0]).kind;
    const bool equality = from.op == st::Op::Equal || from.op == st::Op::NotEqual;
    if (!equality && !both[0].literal && (kind == Type::Kind::Boolean || kind == Type::Kind::Enumeration)) {
        diagnostics->add(messages::program_type_mismatch(from.where, "an operand of `<`, `<=`, `>` or `>=`",
                                                         "a number or a duration", described(both[0])));
        return {};
    }
    return Typed{add(op_of(from.op), bool_, {both[0].node, both[1].node}, from.where), false};
}

Reader::MaybeTyped Reader::arithmetic(Id<st::Expr> id) {
    const st::Expr from = file_->exprs[id];
    std::vector<Typed> operands;
    bool ok = true;
    for (const Id<st::Expr> one : st::operands(*file_, id)) {
        const auto value = expression(one);
        if (value) operands.push_back(*value);
        ok = ok && value;
    }
    const Op op = op_of(from.op);
    if (!ok || operands.empty()) return {};
    if (std::ranges::any_of(operands, [&](const Typed& one) { return type(one).kind == Type::Kind::Time; }))
        return time_arithmetic(from, op, std::move(operands));
    if (!unify(operands, from.where)) return {};
    const Type own = type(operands[0]);
    if (!is_number(own)) {
        diagnostics->add(
            messages::program_type_mismatch(from.where, "an operand", "an integer", described(operands[0])));
        return {};
    }
    const bool literal = std::ranges::all_of(operands, &Typed::literal);
    if (literal) {  // the value of a term of literals is computed exactly
        const std::int64_t a = *value_of(operands[0].node);
        const std::int64_t b = operands.size() > 1 ? *value_of(operands[1].node) : 0;
        std::int64_t value = 0;
        bool overflow = false;
        switch (op) {
        case Op::Negate: overflow = __builtin_sub_overflow(std::int64_t{0}, a, &value); break;
        case Op::Plus: overflow = __builtin_add_overflow(a, b, &value); break;
        case Op::Minus: overflow = __builtin_sub_overflow(a, b, &value); break;
        case Op::Times: overflow = __builtin_mul_overflow(a, b, &value); break;
        default:
            if (b == 0) {
                diagnostics->add(messages::division_by_zero(from.where));
                return {};
            }
            if (b == -1) overflow = __builtin_sub_overflow(std::int64_t{0}, a, &value);
            else value = op == Op::Divide ? a / b : a % b;
            if (b == -1 && op == Op::Modulo) value = 0;
            break;
        }
        if (overflow) {
            diagnostics->add(messages::number_too_large(from.where));
            return {};
        }
        return Typed{number(value, dint_, from.where), true};
    }
    if (op == Op::Times && own.high > 2147483647LL) {
        reject(from.where, "a product of type UDINT", "use DINT");
        return {};
    }
    std::vector<Id<Node>> nodes;
    for (const Typed& operand : operands) nodes.push_back(operand.node);
    return Typed{add(op, program.nodes[operands[0].node].type, std::move(nodes), from.where), false};
}

/// Resolves arithmetic on durations. Durations can be added, subtracted, multiplied by integers and divided by integers
/// (IEC 61131-3, table 30).
Reader::MaybeTyped Reader::time_arithmetic(const st::Expr& from, Op op, std::vector<Typed> operands) {
    const bool sum = op == Op::Plus || op == Op::Minus;
    const bool scaled = (op == Op::Times || op == Op::Divide) && operands.size() == 2;
    if (!sum && !scaled) return reject(from.where, "this operation on durations", "use `+ - * /`"), std::nullopt;
    std::vector<Id<Node>> nodes;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        const Typed& one = operands[i];
        const bool time = type(one).kind == Type::Kind::Time;
        if (sum != time && !(scaled && time && (i == 0 || op == Op::Times))) {
            diagnostics->add(messages::program_type_mismatch(from.where, "an operand",
                                                             sum ? "a duration" : "an integer", described(one)));
            return {};
        }
        if (time || !one.literal) {
            if (!time && type(one).high > 2147483647LL)
                return reject(from.where, "a UDINT as a factor of a duration", "use DINT"), std::nullopt;
            nodes.push_back(one.node);
            continue;
        }
        const auto node = converted(one, dint_, from.where, "an operand");
        if (!node) return {};
        nodes.push_back(*node);
    }
    if (scaled && type(operands[0]).kind == Type::Kind::Time && type(operands[1]).kind == Type::Kind::Time) {
        diagnostics->add(
            messages::program_type_mismatch(from.where, "an operand", "an integer", described(operands[1])));
        return {};
    }
    return Typed{add(op, time_, std::move(nodes), from.where), false};
}

}  // namespace grafverif::program
