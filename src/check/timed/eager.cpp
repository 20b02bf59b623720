// SPDX-License-Identifier: MIT
// Compiles large terms with shared subterms to code without branches. The value of each subterm is stored in one
// register. The code evaluates operands before the terms that contain them.
#include <algorithm>
#include <unordered_map>

#include "check/timed/program.hpp"
#include "support/overloaded.hpp"

namespace grafverif::timed {

namespace {

/// Returns the subterms of `root`; operands precede the terms that contain them.
std::vector<Id<Expr>> subterms(const Exprs& exprs, Id<Expr> root) {
    std::vector<Id<Expr>> open = {root};
    std::unordered_map<std::uint32_t, bool> seen = {{root.index, true}};
    for (std::size_t next = 0; next < open.size(); ++next)
        for (const Id<Expr> operand : exprs.operands(open[next]))
            if (seen.emplace(operand.index, true).second) open.push_back(operand);
    std::ranges::sort(open);
    return open;
}

Opcode operation(Op op) {
    switch (op) {
    case Op::Not: return Opcode::EagerNot;
    case Op::And: return Opcode::EagerAnd;
    case Op::Or: return Opcode::EagerOr;
    case Op::Equal: return Opcode::EagerEqual;
    case Op::NotEqual: return Opcode::EagerUnequal;
    case Op::Less:
    case Op::Greater: return Opcode::EagerLess;  // the caller exchanges the operands
    case Op::LessEqual:
    case Op::GreaterEqual: return Opcode::EagerLessEqual;
    case Op::Negate: return Opcode::Negate;
    case Op::Plus: return Opcode::Add;
    case Op::Minus: return Opcode::Subtract;
    case Op::Times: return Opcode::Multiply;
    case Op::Divide: return Opcode::Divide;
    case Op::Modulo: return Opcode::Modulo;
    case Op::Conditional: return Opcode::EagerChoice;
    case Op::False:
    case Op::True:
    case Op::Integer:
    case Op::Duration:
    case Op::Variable:
    case Op::Step:
    case Op::Timed:
    case Op::Parameter:
    case Op::At:
    case Op::Rise:
    case Op::Fall: break;
    }
    unreachable();
}

}  // namespace

std::uint32_t Compiler::eager(Id<Expr> term, std::uint32_t next, std::uint32_t& result) {
    const Exprs& exprs = network_.exprs;
    const std::vector<Id<Expr>> terms = subterms(exprs, term);
    std::unordered_map<std::uint32_t, std::uint32_t> register_of;
    for (std::uint32_t i = 0; i < terms.size(); ++i) register_of.emplace(terms[i].index, i);
    reserve(static_cast<std::uint32_t>(terms.size()));
    result = register_of.at(term.index);
    std::uint32_t start = next;
    for (auto it = terms.rbegin(); it != terms.rend(); ++it) {
        const Expr& node = exprs[*it];
        const auto operands = exprs.operands(*it);
        const std::uint32_t to = register_of.at(it->index);
        const auto in = [&](std::size_t i) { return register_of.at(operands[i].index); };
        const auto constant = [&](Word value) {
            return emit({.value = value, .yes = start, .to = to, .op = Opcode::Constant});
        };
        if (const auto bits = literal(*it); bits && is_leaf(node.op)) {
            const std::uint32_t truth = constant(1);
            start = test(*bits, truth, constant(0));
        } else if (node.op == Op::Variable) {
            start = load({static_cast<std::uint32_t>(node.value)}, to, start);
        } else if (is_constant(node.op)) {
            start = constant(node.op == Op::Integer ? static_cast<Word>(node.value) : node.op == Op::True ? 1 : 0);
        } else if (node.op == Op::And || node.op == Op::Or) {
            for (std::size_t i = operands.size() - 1; i > 0; --i)
                start = emit({.yes = start, .to = to, .a = i == 1 ? in(0) : to, .b = in(i), .op = operation(node.op)});
        } else {
            const bool exchanged = node.op == Op::Greater || node.op == Op::GreaterEqual;
            const std::uint32_t a = in(exchanged ? 1 : 0);
            const std::uint32_t b = operands.size() > 1 ? in(exchanged ? 0 : 1) : a;
            start = emit({.yes = start,
                          .to = to,
                          .a = a,
                          .b = b,
                          .c = operands.size() > 2 ? in(2) : a,
                          .op = operation(node.op)});
        }
    }
    return start;
}

}  // namespace grafverif::timed
