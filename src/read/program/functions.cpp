// SPDX-License-Identifier: MIT
// Reads calls of functions in expressions: standard functions and conversions (IEC 61131-3), and functions of the
// program.
#include <algorithm>
#include <array>
#include <bit>
#include <string>

#include "read/program/scope.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"

namespace grafverif::program {

namespace {

using Op = Program::Op;

}  // namespace

// -- calls ------------------------------------------------------------------------------------------------------------

/// Returns the positional arguments of a standard function. Reports named arguments and a wrong number of arguments,
/// and sets `ok` to false after an error.
std::vector<Reader::Typed> Reader::arguments(Id<st::Expr> call, std::size_t least, std::size_t most, bool& ok) {
    std::vector<Typed> values;
    const std::vector<Id<st::Expr>> parts = st::operands(*file_, call);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const st::Expr& part = file_->exprs[parts[i]];
        if (part.op == st::Op::Argument || part.op == st::Op::Result) {
            reject(part.where, "a named argument of a standard function", "pass the arguments in order, without names");
            ok = false;
            continue;
        }
        const auto value = expression(parts[i]);
        if (value) values.push_back(*value);
        ok = ok && value;
    }
    const std::size_t count = parts.size() - 1;
    if (count < least || count > most) {
        reject(file_->exprs[call].where, "a call with " + std::to_string(count) + " arguments",
               "pass " + std::to_string(least) + (most == least ? "" : " or more"));
        ok = false;
    }
    return values;
}

Reader::MaybeTyped Reader::call(Id<st::Expr> id) {
    const st::Expr from = file_->exprs[id];
    const st::Expr callee = file_->exprs[from.first];
    if (callee.op != st::Op::Name) return reject(callee.where, "this call", "call a function"), std::nullopt;
    if (const auto unit = units_.find(callee.word.index); unit != units_.end()) return user_function(id, unit->second);
    return standard_function(id, capitals(callee.word));
}

Reader::MaybeTyped Reader::standard_function(Id<st::Expr> id, const std::string& name) {
    const Span where = file_->exprs[id].where;
    if (name.find("_TO_") != std::string::npos) return conversion(id, name);
    if (name == "SHL") return shift(id, Op::ShiftLeft);
    if (name == "SHR") return shift(id, Op::ShiftRight);
    if (name == "ROL") return shift(id, Op::RotateLeft);
    if (name == "ROR") return shift(id, Op::RotateRight);
    struct Function {
        std::string_view name = {};
        Op op = Op::Constant;
        std::size_t least = 0, most = 0;
    };
    static constexpr std::size_t many = 1000;
    static constexpr std::array functions = {
        Function{"ABS", Op::Absolute, 1, 1},   Function{"MIN", Op::Minimum, 2, many},
        Function{"MAX", Op::Maximum, 2, many}, Function{"LIMIT", Op::Limit, 3, 3},
        Function{"SEL", Op::Select, 3, 3},     Function{"MOVE", Op::Constant, 1, 1},
    };
    const auto known = std::ranges::find(functions, name, &Function::name);
    if (known == functions.end()) {
        diagnostics->add(messages::unknown(where, "function", text(file_->exprs[file_->exprs[id].first].word), ""));
        return {};
    }
    bool ok = true;
    std::vector<Typed> values = arguments(id, known->least, known->most, ok);
    if (!ok) return {};
    if (known->op == Op::Constant) return values[0];
    std::optional<Id<Node>> condition;
    if (known->op == Op::Select) {
        condition = converted(values[0], bool_, where, "the condition");
        if (!condition) return {};
        values.erase(values.begin());
    }
    if (!unify(values, where)) return {};
    if (values[0].literal)
        for (Typed& value : values) {
            const auto node = converted(value, int_, where, "an argument");
            if (!node) return {};
            value = {*node, false};
        }
    const Type own = type(values[0]);
    const bool ordered = is_number(own) || (own.kind == Type::Kind::Time && known->op != Op::Absolute);
    if (known->op != Op::Select && !ordered) {
        diagnostics->add(messages::program_type_mismatch(where, "an argument", "a number", described(values[0])));
        return {};
    }
    std::vector<Id<Node>> nodes;
    if (condition) nodes.push_back(*condition);
    for (const Typed& value : values) nodes.push_back(value.node);
    const Id<Type> result = program.nodes[values[0].node].type;
    return Typed{add(known->op, result, std::move(nodes), where), false};
}

/// Resolves a shift or rotation of a bit string by a constant number of bits.
Reader::MaybeTyped Reader::shift(Id<st::Expr> id, Op op) {
    const Span where = file_->exprs[id].where;
    bool ok = true;
    const std::vector<Typed> values = arguments(id, 2, 2, ok);
    if (!ok) return {};
    if (type(values[0]).kind != Type::Kind::Bits) {
        diagnostics->add(messages::program_type_mismatch(where, "the argument", "a bit string", described(values[0])));
        return {};
    }
    const auto places = value_of(values[1].node);
    if (!places || type(values[1]).kind != Type::Kind::Integer || *places < 0)
        return reject(where, "a shift or rotation by this number of bits", "use a nonnegative integer constant"),
               std::nullopt;
    const std::int64_t width = std::popcount(static_cast<std::uint64_t>(type(values[0]).high));
    const bool rotates = op == Op::RotateLeft || op == Op::RotateRight;
    const Id<Node> count = number(rotates ? *places % width : std::min(*places, width), dint_, where);
    return Typed{add(op, program.nodes[values[0].node].type, {values[0].node, count}, where), false};
}

/// Resolves a call of a type conversion, such as `INT_TO_DINT`, `BOOL_TO_INT`, `INT_TO_BOOL` or `DINT_TO_TIME`.
Reader::MaybeTyped Reader::conversion(Id<st::Expr> id, const std::string& name) {
    const Span where = file_->exprs[id].where;
    const std::size_t at = name.find("_TO_");
    const auto from = types_.find(file_->intern(name.substr(0, at)).index);
    const auto to = types_.find(file_->intern(name.substr(at + 4)).index);
    const auto simple = [&](const auto& found) {
        if (found == types_.end()) return false;
        const Type::Kind kind = program.types[found->second].kind;
        return kind == Type::Kind::Boolean || kind == Type::Kind::Integer || kind == Type::Kind::Bits ||
               (kind == Type::Kind::Time && from != types_.end() && to != types_.end() &&
                is_number(program.types[found == from ? to->second : from->second]));
    };
    if (!simple(from) || !simple(to)) {
        reject(where, "the conversion `" + name + "`",
               "convert only between BOOL, bit strings and integers, or between an integer and TIME");
        return {};
    }
    const Id<Type> from_type = from->second, to_type = to->second;
    bool ok = true;
    const std::vector<Typed> values = arguments(id, 1, 1, ok);
    if (!ok) return {};
    const bool changes_sign = file_->dialect == st::Dialect::Codesys && !values[0].literal &&
                              is_number(type(values[0])) && is_number(program.types[from_type]);
    const std::optional<Id<Node>> node = changes_sign ? add(Op::Convert, from_type, {values[0].node}, where)
                                                      : converted(values[0], from_type, where, "the argument");
    if (!node) return {};
    if (changes_sign && program.nodes[values[0].node].type != from_type)
        warn_once("the conversion of an argument to another integer type", "the value is assumed to wrap around",
                  where);
    if (from_type == to_type) return Typed{*node, false};
    const Type::Kind kind = program.types[to_type].kind;
    const Op op = kind == Type::Kind::Boolean ? Op::IsNonzero : kind == Type::Kind::Time ? Op::Narrow : Op::Convert;
    return Typed{add(op, to_type, {*node}, where), false};
}

Reader::MaybeTyped Reader::user_function(Id<st::Expr> id, std::size_t index) {
    const st::Expr from = file_->exprs[id];
    const Id<Unit> callee = declared_[index];
    if (program.units[callee].kind != Unit::Kind::Function) {
        reject(from.where, "a call of `" + program.units[callee].name + "` as a function", "call an instance of it");
        return {};
    }
    calls_[unit_.index].push_back(callee.index);
    refer(file_->exprs[from.first], program.units[callee].origin);
    std::vector<const Variable*> inputs;
    for (const Variable& variable : program.units[callee].variables)
        if (variable.section == Variable::Section::Input) inputs.push_back(&variable);
    std::vector<Id<Node>> given(inputs.size());
    bool ok = true;
    const std::vector<Id<st::Expr>> parts = st::operands(*file_, id);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const st::Expr part = file_->exprs[parts[i]];
        std::size_t place = i - 1;
        Id<st::Expr> value_expr = parts[i];
        if (part.op == st::Op::Argument) {
            const std::string formal = capitals(part.word);
            place = 0;
            while (place < inputs.size() && st::capitals(inputs[place]->name) != formal) ++place;
            if (place < inputs.size()) refer(part, inputs[place]->origin);
            value_expr = part.first;
        }
        if (part.op == st::Op::Result || place >= inputs.size()) {
            reject(part.where, "this argument", "pass one argument for each input of the function");
            ok = false;
            continue;
        }
        const auto value = expression(value_expr);
        const auto node = value ? converted(*value, inputs[place]->type, part.where, "the argument") : std::nullopt;
        if (node) given[place] = *node;
        ok = ok && node;
    }
    for (std::size_t i = 0; i < inputs.size(); ++i)
        if (!given[i].valid()) given[i] = number(inputs[i]->initial, inputs[i]->type, from.where);
    if (!ok) return {};
    const Id<Node> node = add(Op::Call, program.units[callee].variables[0].type, std::move(given), from.where);
    program.nodes[node].unit = callee;
    return Typed{node, false};
}

}  // namespace grafverif::program
