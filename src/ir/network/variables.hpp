// SPDX-License-Identifier: MIT
// Functions that find the variables that a term of a network reads.
#pragma once

#include "grafverif/ir/network.hpp"

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

}  // namespace grafverif
