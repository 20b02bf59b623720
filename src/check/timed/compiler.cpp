// SPDX-License-Identifier: MIT
// Compiles terms to code (see program.hpp). The code of a conjunction first evaluates the operands that test bits, with
// one test for all bits of a word. If an operand may be undefined, the order of the operands is relevant, and the code
// keeps this order.
#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include "check/timed/program.hpp"
#include "support/overloaded.hpp"

namespace grafverif::timed {

namespace {

constexpr std::uint32_t largest_tree = 4096;  // maximum number of nodes of a tree; larger terms are compiled by `eager`
constexpr double largest_value = 4.0e18;      // a term whose absolute value may exceed this limit is treated as one
                                              // that may overflow

Id<Network::Variable> variable_of(const Expr& node) { return {static_cast<std::uint32_t>(node.value)}; }

/// A term that has the form `variable + add`.
struct Shifted {
    std::uint32_t variable = 0;
    std::int64_t add = 0;
};

std::optional<Shifted> shifted(const Exprs& exprs, Id<Expr> term) {
    const Expr& node = exprs[term];
    if (node.op == Op::Variable) return Shifted{variable_of(node).index, 0};
    if (node.op != Op::Plus && node.op != Op::Minus) return {};
    const Expr& left = exprs[exprs.operands(term)[0]];
    const Expr& right = exprs[exprs.operands(term)[1]];
    const auto small = [](const Expr& number) {
        return number.op == Op::Integer && std::abs(number.value) < (std::int64_t{1} << 40);
    };
    if (left.op == Op::Variable && small(right))
        return Shifted{variable_of(left).index, node.op == Op::Plus ? right.value : -right.value};
    if (node.op == Op::Plus && small(left) && right.op == Op::Variable)
        return Shifted{variable_of(right).index, left.value};
    return {};
}

Op mirrored(Op op) {
    switch (op) {
    case Op::Less: return Op::Greater;
    case Op::LessEqual: return Op::GreaterEqual;
    case Op::Greater: return Op::Less;
    case Op::GreaterEqual: return Op::LessEqual;
    default: return op;
    }
}

}  // namespace

Compiler::Compiler(const Network& network, const Layout& layout, Program& program)
    : network_(network), layout_(layout), program_(program) {
    facts_.reserve(network.exprs.size());
    for (std::uint32_t term = 0; term < network.exprs.size(); ++term) facts_.push_back(facts_of({term}));
}

Compiler::Facts Compiler::facts_of(Id<Expr> term) const {
    const Expr& node = network_.exprs[term];
    Facts facts;
    std::vector<Facts> operands;
    for (const Id<Expr> operand : network_.exprs.operands(term)) {
        operands.push_back(facts_[operand.index]);
        facts.tree = std::min(facts.tree + operands.back().tree, 1U << 30U);
        facts.fallible = facts.fallible || operands.back().fallible;
    }
    const auto bound = [&](double low, double high) {
        facts.low = std::min(low, high);
        facts.high = std::max(low, high);
        facts.fallible = facts.fallible || facts.low < -largest_value || facts.high > largest_value;
    };
    const auto& in = operands;
    switch (node.op) {
    case Op::Integer: bound(static_cast<double>(node.value), static_cast<double>(node.value)); break;
    case Op::Variable: {
        const Type& type = network_.variables[variable_of(node)].type;
        bound(static_cast<double>(type.low), static_cast<double>(type.high));
        break;
    }
    case Op::Negate: bound(-in[0].low, -in[0].high); break;
    case Op::Plus: bound(in[0].low + in[1].low, in[0].high + in[1].high); break;
    case Op::Minus: bound(in[0].low - in[1].high, in[0].high - in[1].low); break;
    case Op::Times: {
        const auto [least, most] = std::minmax(
            {in[0].low * in[1].low, in[0].low * in[1].high, in[0].high * in[1].low, in[0].high * in[1].high});
        bound(least, most);
        break;
    }
    case Op::Divide:
    case Op::Modulo: {
        const double most = std::max(std::abs(in[0].low), std::abs(in[0].high));
        bound(-most, most);
        facts.fallible = facts.fallible || (in[1].low <= 0 && in[1].high >= 0);
        break;
    }
    case Op::Conditional: bound(std::min(in[1].low, in[2].low), std::max(in[1].high, in[2].high)); break;
    case Op::False:
    case Op::True:
    case Op::Duration:
    case Op::Step:
    case Op::Timed:
    case Op::Parameter:
    case Op::At:
    case Op::Not:
    case Op::And:
    case Op::Or:
    case Op::Rise:
    case Op::Fall:
    case Op::Equal:
    case Op::NotEqual:
    case Op::Less:
    case Op::LessEqual:
    case Op::Greater:
    case Op::GreaterEqual: break;
    }
    return facts;
}

std::uint32_t Compiler::emit(const Instruction& instruction) {
    program_.code.push_back(instruction);
    return static_cast<std::uint32_t>(program_.code.size() - 1);
}

void Compiler::reserve(std::uint32_t reg) { program_.registers = std::max<std::size_t>(program_.registers, reg + 1); }

std::optional<Compiler::Literal> Compiler::literal(Id<Expr> term) const {
    const Expr& node = network_.exprs[term];
    const auto of = [](const Field& field, std::int64_t value) {
        return Literal{field.word, field.mask(), field.width == 0 ? 0 : field.placed(value)};
    };
    const auto is_bit = [&](const Expr& leaf) {
        return leaf.op == Op::Variable && network_.variables[variable_of(leaf)].type == Type{} &&
               !is_chosen(variable_of(leaf));
    };
    if (is_bit(node)) return of(layout_.variables[variable_of(node).index], 1);
    if (node.op == Op::At) return of(layout_.locations[at_process(node)], at_location(node));
    if (node.op == Op::Not) {
        const Expr& inner = network_.exprs[network_.exprs.operands(term)[0]];
        if (is_bit(inner)) return of(layout_.variables[variable_of(inner).index], 0);
    }
    if (node.op == Op::Equal) {
        const Expr& left = network_.exprs[network_.exprs.operands(term)[0]];
        const Expr& right = network_.exprs[network_.exprs.operands(term)[1]];
        if (left.op != Op::Variable || right.op != Op::Integer || is_chosen(variable_of(left))) return {};
        const Network::Variable& variable = network_.variables[variable_of(left)];
        if (right.value < variable.type.low || right.value > variable.type.high) return {};
        return of(layout_.variables[variable_of(left).index], right.value);
    }
    return {};
}

std::uint32_t Compiler::test(const Literal& literal, std::uint32_t yes, std::uint32_t no) {
    return emit(
        {.mask = literal.mask, .value = literal.value, .yes = yes, .no = no, .word = literal.word, .op = Opcode::Test});
}

void Compiler::choose(const InputChoice& choice, std::size_t number) {
    for (std::size_t column = 0; column < choice.variables.size(); ++column) {
        Chosen& chosen = chosen_[choice.variables[column].index];
        chosen.set = Choices::set(number);
        for (const std::vector<std::int64_t>& valuation : choice.valuations) chosen.values.push_back(valuation[column]);
    }
}

/// Generates a test that a chosen variable has a value in low..high. A chosen variable is an output of an instance
/// whose outputs the abstraction chooses arbitrarily (InputChoice).
std::uint32_t Compiler::chosen_within(Id<Network::Variable> variable, std::int64_t low, std::int64_t high,
                                      std::uint32_t yes, std::uint32_t no) {
    const Chosen& chosen = chosen_.at(variable.index);
    Word valuations = 0;
    for (std::size_t row = 0; row < chosen.values.size(); ++row)
        if (low <= chosen.values[row] && chosen.values[row] <= high) valuations |= Word{1} << row;
    return emit({.value = valuations, .yes = yes, .no = no, .to = chosen.set, .op = Opcode::Choose});
}

std::uint32_t Compiler::load(Id<Network::Variable> variable, std::uint32_t to, std::uint32_t next) {
    reserve(to);
    if (is_chosen(variable)) {
        const std::set<std::int64_t> values(chosen_.at(variable.index).values.begin(),
                                            chosen_.at(variable.index).values.end());
        std::uint32_t start = Program::no;  // code for the case that none of the remaining values is possible
        for (const std::int64_t value : values) {
            const std::uint32_t constant =
                emit({.value = static_cast<Word>(value), .yes = next, .to = to, .op = Opcode::Constant});
            start = start == Program::no ? constant : chosen_within(variable, value, value, constant, start);
        }
        return start;
    }
    const Field& field = layout_.variables[variable.index];
    return emit({.mask = field.mask(),
                 .value = static_cast<Word>(field.low),
                 .yes = next,
                 .to = to,
                 .word = field.word,
                 .shift = field.shift,
                 .op = Opcode::Load});
}

std::uint32_t Compiler::condition(Id<Expr> term, std::uint32_t yes, std::uint32_t no) {
    if (facts_[term.index].tree <= largest_tree) return boolean(term, yes, no, 0);
    const std::uint32_t truth = emit({.yes = yes, .no = no, .op = Opcode::Truth});
    std::uint32_t result = 0;
    const std::uint32_t start = eager(term, truth, result);
    program_.code[truth].a = result;
    return start;
}

std::uint32_t Compiler::assignment(Id<Network::Variable> target, Id<Expr> value, std::uint32_t next) {
    const Field& field = layout_.variables[target.index];
    const Type& type = network_.variables[target].type;
    const Op op = network_.exprs[value].op;
    if (type == Type{} && facts_[value.index].tree <= largest_tree) {
        const std::uint32_t set =
            emit({.mask = ~Word{0}, .value = field.mask(), .yes = next, .word = field.word, .op = Opcode::Patch});
        const std::uint32_t clear = emit({.mask = ~field.mask(), .yes = next, .word = field.word, .op = Opcode::Patch});
        return boolean(value, set, clear, 0);
    }
    const std::int64_t constant = network_.exprs[value].value;
    if (op == Op::Integer && type.low <= constant && constant <= type.high && field.width != 0)
        return emit({.mask = ~field.mask(),
                     .value = field.placed(constant),
                     .yes = next,
                     .word = field.word,
                     .op = Opcode::Patch});
    const std::uint32_t store = emit({.mask = field.mask(),
                                      .value = static_cast<Word>(type.low),
                                      .span = static_cast<Word>(type.high - type.low),
                                      .yes = next,
                                      .to = target.index,
                                      .word = field.word,
                                      .shift = field.shift,
                                      .op = Opcode::Store});
    if (facts_[value.index].tree <= largest_tree && !type.boolean) return integer(value, 0, store);
    std::uint32_t result = 0;
    const std::uint32_t start = eager(value, store, result);
    program_.code[store].a = result;
    return start;
}

std::uint32_t Compiler::boolean(Id<Expr> term, std::uint32_t yes, std::uint32_t no, std::uint32_t base) {
    const Expr& node = network_.exprs[term];
    const auto operands = network_.exprs.operands(term);
    if (const auto bits = literal(term)) return test(*bits, yes, no);
    switch (node.op) {
    case Op::True: return yes;
    case Op::False: return no;
    case Op::Not: return boolean(operands[0], no, yes, base);
    case Op::And:
    case Op::Or: return junction(term, yes, no, base);
    case Op::Conditional: {
        const std::uint32_t then = boolean(operands[1], yes, no, base);
        return boolean(operands[0], then, boolean(operands[2], yes, no, base), base);
    }
    case Op::Equal:
    case Op::NotEqual:
    case Op::Less:
    case Op::LessEqual:
    case Op::Greater:
    case Op::GreaterEqual: return comparison(term, yes, no, base);
    case Op::Variable:  // a Boolean variable, whose value may be chosen (InputChoice)
        if (is_chosen(variable_of(node))) return chosen_within(variable_of(node), 1, 1, yes, no);
        return emit({.mask = layout_.variables[variable_of(node).index].mask(),
                     .yes = no,
                     .no = yes,
                     .word = layout_.variables[variable_of(node).index].word,
                     .op = Opcode::Test});
    case Op::Integer:
    case Op::Duration:
    case Op::Step:
    case Op::Timed:
    case Op::Parameter:
    case Op::At:
    case Op::Rise:
    case Op::Fall:
    case Op::Negate:
    case Op::Plus:
    case Op::Minus:
    case Op::Times:
    case Op::Divide:
    case Op::Modulo: break;
    }
    unreachable();
}

/// Compiles an And or Or. An Or is compiled as an And of the negated operands in which the successors `yes` and `no`
/// are exchanged. A negated operand is also compiled with exchanged successors; if the operand tests a single bit, the
/// required value of the bit is inverted instead.
std::uint32_t Compiler::junction(Id<Expr> term, std::uint32_t yes, std::uint32_t no, std::uint32_t base) {
    const auto operands = network_.exprs.operands(term);
    const bool conjunction = network_.exprs[term].op == Op::And;
    std::vector<Literal> words;
    std::vector<Id<Expr>> others;
    bool contradiction = false;
    for (const Id<Expr> operand : operands) {
        auto bits = fallible(term) ? std::nullopt : literal(operand);
        const bool usable = bits && (conjunction || std::has_single_bit(bits->mask));
        if (!usable) {
            others.push_back(operand);
            continue;
        }
        if (!conjunction) bits->value ^= bits->mask;
        const auto same = std::ranges::find(words, bits->word, &Literal::word);
        if (same == words.end()) {
            words.push_back(*bits);
            continue;
        }
        contradiction = contradiction || ((same->value ^ bits->value) & same->mask & bits->mask) != 0;
        same->mask |= bits->mask;
        same->value |= bits->value;
    }
    const std::uint32_t all = conjunction ? yes : no;
    const std::uint32_t broken = conjunction ? no : yes;
    if (contradiction) return broken;
    std::uint32_t start = all;
    for (auto operand = others.rbegin(); operand != others.rend(); ++operand)
        start = conjunction ? boolean(*operand, start, broken, base) : boolean(*operand, broken, start, base);
    for (auto word = words.rbegin(); word != words.rend(); ++word) start = test(*word, start, broken);
    return start;
}

std::uint32_t Compiler::comparison(Id<Expr> term, std::uint32_t yes, std::uint32_t no, std::uint32_t base) {
    const Exprs& exprs = network_.exprs;
    Op op = exprs[term].op;
    Id<Expr> left = exprs.operands(term)[0];
    Id<Expr> right = exprs.operands(term)[1];
    const auto is_boolean = [&](Id<Expr> id) {
        while (exprs[id].op == Op::Conditional) id = exprs.operands(id)[1];
        const Op kind = exprs[id].op;
        return kind == Op::Variable ? network_.variables[variable_of(exprs[id])].type.boolean
                                    : kind != Op::Integer && !is_arithmetic(kind);
    };
    if (op == Op::NotEqual) {
        op = Op::Equal;
        std::swap(yes, no);
    }
    if (op == Op::Equal && is_boolean(left) && is_boolean(right)) {
        const std::uint32_t same = boolean(right, yes, no, base);
        return boolean(left, same, boolean(right, no, yes, base), base);
    }
    if (exprs[left].op == Op::Integer) {
        std::swap(left, right);
        op = mirrored(op);
    }
    if (const auto side = shifted(exprs, left);
        side && exprs[right].op == Op::Integer && std::abs(exprs[right].value) < (std::int64_t{1} << 40)) {
        const Field& field = layout_.variables[side->variable];
        const Type& type = network_.variables[{side->variable}].type;
        const std::int64_t bound = exprs[right].value - side->add;
        std::int64_t low = type.low, high = type.high;
        if (op == Op::Equal || op == Op::LessEqual) high = std::min(high, bound);
        if (op == Op::Less) high = std::min(high, bound - 1);
        if (op == Op::Equal || op == Op::GreaterEqual) low = std::max(low, bound);
        if (op == Op::Greater) low = std::max(low, bound + 1);
        if (low > high) return no;
        if (low == type.low && high == type.high) return yes;
        if (is_chosen({side->variable})) return chosen_within({side->variable}, low, high, yes, no);
        return emit(field_within(field, low - field.low, high - field.low, yes, no));
    }
    if (op == Op::Greater || op == Op::GreaterEqual) {
        std::swap(left, right);
        op = mirrored(op);
    }
    const Opcode how = op == Op::Equal ? Opcode::Equal : op == Op::Less ? Opcode::Less : Opcode::LessEqual;
    reserve(base + 1);
    const std::uint32_t compare = emit({.yes = yes, .no = no, .a = base, .b = base + 1, .op = how});
    return integer(left, base, integer(right, base + 1, compare));
}

std::uint32_t Compiler::integer(Id<Expr> term, std::uint32_t to, std::uint32_t next) {
    reserve(to + 1);
    const Expr& node = network_.exprs[term];
    const auto operands = network_.exprs.operands(term);
    const auto binary = [&](Opcode op) {
        const std::uint32_t last = emit({.yes = next, .to = to, .a = to, .b = to + 1, .op = op});
        return integer(operands[0], to, integer(operands[1], to + 1, last));
    };
    switch (node.op) {
    case Op::Integer:
        return emit({.value = static_cast<Word>(node.value), .yes = next, .to = to, .op = Opcode::Constant});
    case Op::Variable: return load(variable_of(node), to, next);
    case Op::Negate:
        return integer(operands[0], to, emit({.yes = next, .to = to, .a = to, .b = to, .op = Opcode::Negate}));
    case Op::Plus: return binary(Opcode::Add);
    case Op::Minus: return binary(Opcode::Subtract);
    case Op::Times: return binary(Opcode::Multiply);
    case Op::Divide: return binary(Opcode::Divide);
    case Op::Modulo: return binary(Opcode::Modulo);
    case Op::Conditional: {
        const std::uint32_t then = integer(operands[1], to, next);
        return boolean(operands[0], then, integer(operands[2], to, next), to);
    }
    case Op::False:
    case Op::True:
    case Op::Duration:
    case Op::Step:
    case Op::Timed:
    case Op::Parameter:
    case Op::At:
    case Op::Not:
    case Op::And:
    case Op::Or:
    case Op::Rise:
    case Op::Fall:
    case Op::Equal:
    case Op::NotEqual:
    case Op::Less:
    case Op::LessEqual:
    case Op::Greater:
    case Op::GreaterEqual: break;
    }
    unreachable();
}

}  // namespace grafverif::timed
