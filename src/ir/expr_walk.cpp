// SPDX-License-Identifier: MIT
// Walks over the terms of an Exprs table: copying into another table, and the leaves of a term. Both visit each
// shared subterm once.
#include <unordered_set>

#include "grafverif/ir/expr.hpp"

namespace grafverif {

namespace {

void collect(const Exprs& exprs, Id<Expr> root, std::unordered_set<std::uint32_t>& seen, std::vector<Id<Expr>>& found) {
    const Expr& node = exprs[root];
    if (is_constant(node.op) || !seen.insert(root.index).second) return;
    if (is_leaf(node.op)) found.push_back(root);
    for (const Id<Expr> operand : exprs.operands(root)) collect(exprs, operand, seen, found);
}

}  // namespace

Id<Expr> TermCopier::operator()(Id<Expr> root) {
    const Expr node = (*from_)[root];   // by value: `to` may be `from`, and grow
    if (node.op == Op::False || node.op == Op::True) return to_->constant(node.op == Op::True);
    if (node.op == Op::Integer) return to_->integer(node.value);
    if (const auto known = copies_.find(root.index); known != copies_.end()) return known->second;
    std::vector<Id<Expr>> operands(from_->operands(root).begin(), from_->operands(root).end());
    for (Id<Expr>& operand : operands) operand = (*this)(operand);
    const bool is_edge = edge_ && (node.op == Op::Rise || node.op == Op::Fall);
    const Id<Expr> result = operands.empty() ? leaf_(node) : is_edge ? edge_(node.op, operands[0]) : to_->apply(node.op, operands);
    copies_.emplace(root.index, result);
    return result;
}

Id<Expr> translate(const Exprs& from, Id<Expr> root, Exprs& to, const std::function<Id<Expr>(const Expr&)>& leaf) {
    return TermCopier(from, to, [&](const Expr& node) {
        return node.op == Op::Duration ? to.duration(node.value) : leaf(node);
    })(root);
}

std::vector<Id<Expr>> leaves(const Exprs& exprs, Id<Expr> root) {
    std::unordered_set<std::uint32_t> seen;
    std::vector<Id<Expr>> found;
    collect(exprs, root, seen, found);
    return found;
}

}  // namespace grafverif
