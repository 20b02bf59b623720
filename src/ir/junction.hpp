// SPDX-License-Identifier: MIT
// Functions that return the operands of conjunctions and disjunctions, and that search a term for divisions.
#pragma once

#include <algorithm>
#include <vector>

#include "grafverif/ir/expr.hpp"

namespace grafverif {

/// Returns the operands of `term` if its operator is `op`; otherwise a list that contains only `term`.
inline std::vector<Id<Expr>> operands_of(const Exprs& exprs, Id<Expr> term, Op op) {
    if (exprs[term].op != op) return {term};
    const auto operands = exprs.operands(term);
    return {operands.begin(), operands.end()};
}

/// True if the term contains a quotient or a remainder, so that its value may be undefined. `seen` marks the visited
/// subterms, by index; subterms that are already marked are not searched again.
inline bool may_divide(const Exprs& exprs, Id<Expr> root, std::vector<bool>& seen) {
    if (seen[root.index]) return false;
    seen[root.index] = true;
    const Op op = exprs[root].op;
    return op == Op::Divide || op == Op::Modulo || std::ranges::any_of(exprs.operands(root), [&](Id<Expr> operand) {
               return may_divide(exprs, operand, seen);
           });
}

}  // namespace grafverif
