// SPDX-License-Identifier: MIT
// Reads expressions with their types. An integer literal adapts to the type of the other operands. Integers of
// different types are converted to the type that contains the other.
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

bool is_number(const Type& type) { return type.kind == Type::Kind::Integer; }
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
    const Type& target = program.types[to];
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
        if (const auto known = value_of(value.node)) return number(*known, to, where);
        return add(Op::Convert, to, {value.node}, where);
    }
    diagnostics->add(messages::program_type_mismatch(where, what, "`" + target.name + "`", described(value)));
    return {};
}

/// Converts all operands to one type.
bool Reader::unify(std::vector<Typed>& operands, Span where) {
    Id<Type> common;
    for (const Typed& operand : operands) {
        if (operand.literal) continue;
        const Id<Type> own = program.nodes[operand.node].type;
        if (!common.valid() || (is_number(program.types[own]) && is_number(program.types[common]) &&
                                contains(program.types[own], program.types[common])))
            common = own;
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
            if (known != values_.end() && type != types_.end() && type->second == known->second.first)
                return Typed{number(known->second.second, type->second, from.where), false};
        }
        reject(from.where, "this literal", "use Boolean values, integers and durations");
        return {};
    }
    case st::Op::Name:
        if (const auto value = values_.find(from.word.index);
            value != values_.end() && !scopes_[unit_.index].variables.contains(from.word.index))
            return Typed{number(value->second.second, value->second.first, from.where), false};
        [[fallthrough]];
    case st::Op::Member:
    case st::Op::Address: {
        const auto found = variable(id);
        if (!found) return {};
        if (program.types[found->type].kind == Type::Kind::Block) {
            reject(from.where, "a function block as a value", "read one of its outputs");
            return {};
        }
        if (found->variable->constant) return Typed{number(found->variable->initial, found->type, from.where), false};
        limit_step_time(*found);
        const Id<Node> node = add(Op::Read, found->type, {}, from.where);
        program.nodes[node].place = found->place;
        return Typed{node, false};
    }
    case st::Op::Index: reject(from.where, "an array", "use one variable for each element"); return {};
    case st::Op::Dereference: reject(from.where, "a pointer", "use the variable itself"); return {};
    case st::Op::Power: reject(from.where, "`**`", "write it as a product"); return {};
    default: reject(from.where, "this expression", "use operators, variables and calls"); return {};
    }
}

Reader::MaybeTyped Reader::junction(Id<st::Expr> id) {
    const st::Expr from = file_->exprs[id];
    std::vector<Id<Node>> operands;
    bool ok = true;
    for (const Id<st::Expr> one : st::operands(*file_, id)) {
        const auto value = expression(one);
        if (!value) {
            ok = false;
            continue;
        }
        if (type(*value).kind == Type::Kind::Bits || (is_number(type(*value)) && !value->literal)) {
            reject(file_->exprs[one].where, "a bitwise operator", "use Boolean operands");
            ok = false;
            continue;
        }
        const auto node = converted(*value, bool_, file_->exprs[one].where, "an operand");
        if (node) operands.push_back(*node);
        ok = ok && node;
    }
    if (!ok) return {};
    return Typed{add(op_of(from.op), bool_, std::move(operands), from.where), false};
}

Reader::MaybeTyped Reader::comparison(Id<st::Expr> id) {
    const st::Expr from = file_->exprs[id];
    const std::vector<Id<st::Expr>> parts = st::operands(*file_, id);
    if (parts.size() != 2) return {};  // the parser has reported this
    const auto [left, right] = compared(parts);
    if (!left || !right) return {};
    std::vector<Typed> both = {*left, *right};
    if (!unify(both, from.where)) return {};
    const Type::Kind kind = type(both[0]).kind;
    const bool equality = from.op == st::Op::Equal || from.op == st::Op::NotEqual;
    if (!equality && !both[0].literal && (kind == Type::Kind::Boolean || kind == Type::Kind::Enumeration)) {
        diagnostics->add(messages::program_type_mismatch(from.where, "the operand of an order",
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
    if (!ok || operands.empty() || !unify(operands, from.where)) return {};
    const Type own = type(operands[0]);
    if (!is_number(own)) {
        if (own.kind == Type::Kind::Time) reject(from.where, "arithmetic on durations", "compare durations only");
        else
            diagnostics->add(
                messages::program_type_mismatch(from.where, "an operand", "an integer", described(operands[0])));
        return {};
    }
    const Op op = op_of(from.op);
    const bool literal = std::ranges::all_of(operands, &Typed::literal);
    if (literal) {  // computed exactly, because it is a literal
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
        reject(from.where, "a product of UDINT", "use DINT");
        return {};
    }
    std::vector<Id<Node>> nodes;
    for (const Typed& operand : operands) nodes.push_back(operand.node);
    return Typed{add(op, program.nodes[operands[0].node].type, std::move(nodes), from.where), false};
}

// -- calls ------------------------------------------------------------------------------------------------------------

/// Returns the arguments of a standard function, which are positional or named `IN`, `IN1`, ... in order.
std::vector<Reader::Typed> Reader::arguments(Id<st::Expr> call, std::size_t least, std::size_t most, bool& ok) {
    std::vector<Typed> values;
    const std::vector<Id<st::Expr>> parts = st::operands(*file_, call);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const st::Expr& part = file_->exprs[parts[i]];
        if (part.op == st::Op::Argument || part.op == st::Op::Result) {
            reject(part.where, "a named argument of a standard function", "give its arguments in order");
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
               "give " + std::to_string(least) + (most == least ? "" : " or more"));
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

/// Resolves a conversion such as `INT_TO_DINT`, `BOOL_TO_INT` or `INT_TO_BOOL`.
Reader::MaybeTyped Reader::conversion(Id<st::Expr> id, const std::string& name) {
    const Span where = file_->exprs[id].where;
    const std::size_t at = name.find("_TO_");
    const auto from = types_.find(file_->intern(name.substr(0, at)).index);
    const auto to = types_.find(file_->intern(name.substr(at + 4)).index);
    const auto simple = [&](const auto& found) {
        if (found == types_.end()) return false;
        const Type::Kind kind = program.types[found->second].kind;
        return kind == Type::Kind::Boolean || kind == Type::Kind::Integer || kind == Type::Kind::Bits;
    };
    if (!simple(from) || !simple(to)) {
        reject(where, "the conversion `" + name + "`", "convert between BOOL and integers");
        return {};
    }
    const Id<Type> from_type = from->second, to_type = to->second;
    bool ok = true;
    const std::vector<Typed> values = arguments(id, 1, 1, ok);
    if (!ok) return {};
    const auto node = converted(values[0], from_type, where, "the argument");
    if (!node) return {};
    if (from_type == to_type) return Typed{*node, false};
    const bool boolean_result = program.types[to_type].kind == Type::Kind::Boolean;
    return Typed{add(boolean_result ? Op::IsNonzero : Op::Convert, to_type, {*node}, where), false};
}

Reader::MaybeTyped Reader::user_function(Id<st::Expr> id, std::size_t index) {
    const st::Expr from = file_->exprs[id];
    const Id<Unit> callee = declared_[index];
    if (program.units[callee].kind != Unit::Kind::Function) {
        reject(from.where, "a call of `" + program.units[callee].name + "` as a function", "call an instance of it");
        return {};
    }
    calls_[unit_.index].push_back(callee.index);
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
            value_expr = part.first;
        }
        if (part.op == st::Op::Result || place >= inputs.size()) {
            reject(part.where, "this argument", "give one argument for each input of the function");
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

// -- variables --------------------------------------------------------------------------------------------------------

std::optional<Reader::Found> Reader::named(Id<st::Word> word, Span where) {
    for (const Id<Unit> id : {unit_, program.globals}) {
        const auto known = scopes_[id.index].variables.find(word.index);
        if (known == scopes_[id.index].variables.end()) continue;
        Variable& found = program.units[id].variables[known->second];
        return Found{{id == program.globals, found.offset}, found.type, &found, nullptr, false};
    }
    std::vector<std::string> candidates;
    for (const Id<Unit> id : {unit_, program.globals})
        for (const Variable& variable : program.units[id].variables) candidates.push_back(variable.name);
    diagnostics->add(messages::unknown(where, "variable", text(word), nearest_of(text(word), candidates)));
    return {};
}

std::optional<Reader::Found> Reader::variable(Id<st::Expr> path) {
    const st::Expr from = file_->exprs[path];
    if (from.op == st::Op::Name) return named(from.word, from.where);
    if (from.op == st::Op::Address) {
        reject(from.where, "a direct address in a statement", "declare a variable `AT` it");
        return {};
    }
    if (from.op != st::Op::Member) {
        reject(from.where, "this variable", "use a name, or an output of an instance");
        return {};
    }
    if (const auto found = chart_member(path)) return found;
    const st::Expr& owner_expr = file_->exprs[from.first];
    if (any_member_ && owner_expr.op == st::Op::Name &&
        st::capitals(text(owner_expr.word)) == st::capitals(program.units[unit_].name) &&
        !scopes_[unit_.index].variables.contains(owner_expr.word.index))
        return named(from.word, from.where);
    const auto owner = variable(from.first);
    if (!owner) return {};
    const Type& type = program.types[owner->type];
    if (type.kind != Type::Kind::Block) {
        diagnostics->add(messages::program_type_mismatch(owner_expr.where, "the owner of a member",
                                                         "an instance of a function block", "`" + type.name + "`"));
        return {};
    }
    const auto known = scopes_[type.unit.index].variables.find(from.word.index);
    Variable* found = known == scopes_[type.unit.index].variables.end()
                          ? nullptr
                          : &program.units[type.unit].variables[known->second];
    const bool readable = any_member_ && found && found->section != Variable::Section::Temporary;
    const bool input = found && found->section == Variable::Section::Input && !chart_units_.contains(type.unit.index);
    const bool visible = found && (readable || input || found->section == Variable::Section::Output);
    if (!visible) {
        std::vector<std::string> candidates;
        for (const Variable& variable : program.units[type.unit].variables)
            if (variable.section == Variable::Section::Input || variable.section == Variable::Section::Output)
                candidates.push_back(variable.name);
        diagnostics->add(
            messages::unknown(from.where, "variable", text(from.word), nearest_of(text(from.word), candidates)));
        return {};
    }
    return Found{{owner->place.global, owner->place.offset + found->offset}, found->type, found, owner->variable, true};
}

std::optional<Id<Node>> Reader::condition(Id<st::Expr> root) {
    unit_ = program.main;
    any_member_ = true;
    const auto value = expression(root);
    any_member_ = false;
    if (!value) return {};
    return converted(*value, bool_, file_->exprs[root].where, "the expression");
}

}  // namespace grafverif::program
