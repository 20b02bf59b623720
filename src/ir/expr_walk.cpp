// SPDX-License-Identifier: MIT
// Walks over the terms of an Exprs table: copying into another table, and the leaves of a term. Both visit each
// shared subterm once.
#include <unordered_map>
#include <unordered_set>

#include "grafverif/ir/expr.hpp"

namespace grafverif {

namespace {

using Copies = std::unordered_map<std::uint32_t, Id<Expr>>;

Id<Expr> copy(const Exprs& from, Id<Expr> root, Exprs& to, const std::function<Id<Expr>(const Expr&)>& leaf,
              Copies& copies) {
    const Expr node = from[root];   // by value: `to` may be `from`, and grow
    if (node.op == Op::False || node.op == Op::True) return to.constant(node.op == Op::True);
    if (node.op == Op::Integer) return to.integer(node.value);
    if (node.op == Op::Duration) return to.duration(node.value);
    if (is_leaf(node.op)) return leaf(node);
    if (const auto known = copies.find(root.index); known != copies.end()) return known->second;
    std::vector<Id<Expr>> operands(from.operands(root).begin(), from.operands(root).end());
    for (Id<Expr>& operand : operands) operand = copy(from, operand, to, leaf, copies);
    const Id<Expr> result = to.apply(node.op, operands);
    copies.emplace(root.index, result);
    return result;
}

void collect(const Exprs& exprs, Id<Expr> root, std::unordered_set<std::uint32_t>& seen, std::vector<Id<Expr>>& found) {
    const Expr& node = exprs[root];
    if (is_constant(node.op) || !seen.insert(root.index).second) return;
    if (is_leaf(node.op)) found.push_back(root);
    for (const Id<Expr> operand : exprs.operands(root)) collect(exprs, operand, seen, found);
}

}  // namespace

Id<Expr> translate(const Exprs& from, Id<Expr> root, Exprs& to, const std::function<Id<Expr>(const Expr&)>& leaf) {
    Copies copies;
    return copy(from, root, to, leaf, copies);
}

std::vector<Id<Expr>> leaves(const Exprs& exprs, Id<Expr> root) {
    std::unordered_set<std::uint32_t> seen;
    std::vector<Id<Expr>> found;
    collect(exprs, root, seen, found);
    return found;
}

}  // namespace grafverif
