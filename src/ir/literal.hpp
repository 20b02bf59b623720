// SPDX-License-Identifier: MIT
#pragma once

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"

namespace grafverif {

/// Returns the constant `value` of `type` as a term.
inline Id<Expr> literal(Exprs& exprs, Type type, std::int64_t value) {
    return type.boolean ? exprs.constant(value != 0) : exprs.integer(value);
}

}  // namespace grafverif
