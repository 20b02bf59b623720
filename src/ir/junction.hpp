// SPDX-License-Identifier: MIT
// Operands of conjunctions and disjunctions.
#pragma once

#include <vector>

#include "grafverif/ir/expr.hpp"

namespace grafverif {

/// The operands if `term` has the operator `op`; otherwise the term itself.
inline std::vector<Id<Expr>> operands_of(const Exprs& exprs, Id<Expr> term, Op op) {
    if (exprs[term].op != op) return {term};
    const auto operands = exprs.operands(term);
    return {operands.begin(), operands.end()};
}

}  // namespace grafverif
