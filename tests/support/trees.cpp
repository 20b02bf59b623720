// SPDX-License-Identifier: MIT
#include "support/trees.hpp"

#include <limits>

#include "support/overloaded.hpp"

namespace grafverif {

Span Trees::next(bool begins_group) {
    const std::uint32_t begin = position_;
    position_ += 2;
    if (begins_group) file_->gaps.push_back(begin);
    return {{}, begin, begin + 1};
}

Id<tree::Expr> Trees::node(tree::Op op, std::initializer_list<Id<tree::Expr>> operands) {
    tree::Expr expr;
    expr.op = op;
    const Id<tree::Expr> id = file_->exprs.add(expr);
    for (const Id<tree::Expr> operand : operands) tree::append(file_->exprs, id, operand);
    return id;
}

Id<tree::Expr> Trees::number(std::int64_t value) {
    // The absolute value of the least number exceeds the greatest number, so the least number is
    // written as a difference.
    if (value == std::numeric_limits<std::int64_t>::min()) return node(tree::Op::Minus, {number(value + 1), number(1)});
    const Id<tree::Expr> id = node(tree::Op::Number, {});
    file_->exprs[id].value = value < 0 ? -value : value;
    return value < 0 ? node(tree::Op::Negate, {id}) : id;
}

Id<tree::Expr> Trees::duration(std::int64_t milliseconds) {
    const Id<tree::Expr> id = node(tree::Op::Duration, {});
    file_->exprs[id].value = milliseconds;
    return id;
}

Id<tree::Expr> Trees::path(std::string_view text) {
    const std::size_t dot = text.rfind('.');
    if (dot == std::string_view::npos) {
        const Id<tree::Expr> id = node(tree::Op::Name, {});
        file_->exprs[id].word = words_.intern(text);
        return id;
    }
    const Id<tree::Expr> id = node(tree::Op::Member, {path(text.substr(0, dot))});
    file_->exprs[id].word = words_.intern(text.substr(dot + 1));
    return id;
}

namespace {

tree::Op tree_op(Op op) {
    switch (op) {
    case Op::False: return tree::Op::False;
    case Op::True: return tree::Op::True;
    case Op::Integer: return tree::Op::Number;
    case Op::Duration: return tree::Op::Duration;
    case Op::Not: return tree::Op::Not;
    case Op::And: return tree::Op::And;
    case Op::Or: return tree::Op::Or;
    case Op::Rise: return tree::Op::Rise;
    case Op::Fall: return tree::Op::Fall;
    case Op::Equal: return tree::Op::Equal;
    case Op::NotEqual: return tree::Op::NotEqual;
    case Op::Less: return tree::Op::Less;
    case Op::LessEqual: return tree::Op::LessEqual;
    case Op::Greater: return tree::Op::Greater;
    case Op::GreaterEqual: return tree::Op::GreaterEqual;
    case Op::Negate: return tree::Op::Negate;
    case Op::Plus: return tree::Op::Plus;
    case Op::Minus: return tree::Op::Minus;
    case Op::Times: return tree::Op::Times;
    case Op::Divide: return tree::Op::Divide;
    case Op::Modulo: return tree::Op::Modulo;
    case Op::Variable:
    case Op::Step:
    case Op::Timed:
    case Op::Parameter:
    case Op::At:
    case Op::Conditional: break;  // the caller provides leaves, and the language has no conditionals
    }
    unreachable();
}

}  // namespace

Id<tree::Expr> Trees::expression(const Exprs& exprs, Id<Expr> root,
                                 const std::function<Id<tree::Expr>(const Expr&)>& leaf) {
    const Expr& written = exprs[root];
    if (is_leaf(written.op)) return leaf(written);
    if (written.op == Op::Integer) return number(written.value);
    if (written.op == Op::Duration) return duration(written.value);
    const Id<tree::Expr> id = node(tree_op(written.op), {});
    for (const Id<Expr> operand : exprs.operands(root)) {
        const Id<tree::Expr> child = expression(exprs, operand, leaf);
        file_->exprs[child].bracketed = written.op == Op::Or;  // brackets, as in `a || (b && c)`
        tree::append(file_->exprs, id, child);
    }
    return id;
}

}  // namespace grafverif
