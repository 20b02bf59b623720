// SPDX-License-Identifier: MIT
// Functions that find the variables that a term of a network reads.
#pragma once

#include <algorithm>

#include "grafverif/ir/network.hpp"
#include "ir/junction.hpp"

namespace grafverif {

/// Returns the variable of a leaf `Op::Variable`.
inline Id<Network::Variable> variable_of(const Exprs& exprs, Id<Expr> leaf) {
    return {static_cast<std::uint32_t>(exprs[leaf].value)};
}

/// Calls `visit` for each variable that `term` reads.
template <class Visit>
void each_variable(const Exprs& exprs, Id<Expr> term, const Visit& visit) {
    for (const Id<Expr> leaf : leaves(exprs, term))
        if (exprs[leaf].op == Op::Variable) visit(variable_of(exprs, leaf));
}

/// True if `variable`, or its negation if `negated` is true, is a conjunct of `guard`.
inline bool has_conjunct(const Exprs& exprs, Id<Expr> guard, Id<Network::Variable> variable, bool negated) {
    return std::ranges::any_of(operands_of(exprs, guard, Op::And), [&](Id<Expr> conjunct) {
        const bool is_negation = exprs[conjunct].op == Op::Not;
        const Id<Expr> term = is_negation ? exprs.operands(conjunct)[0] : conjunct;
        return is_negation == negated && exprs[term].op == Op::Variable && variable_of(exprs, term) == variable;
    });
}

/// Returns the type of a variable; other leaves are Boolean.
inline Type type_of(const Network& network, const Expr& leaf) {
    return leaf.op == Op::Variable ? network.variables[{static_cast<std::uint32_t>(leaf.value)}].type : Type{};
}

}  // namespace grafverif
