// SPDX-License-Identifier: MIT
// Conditions under which a value is undefined or outside of its variable's range: an assignment would leave the range
// of its target or divide by zero. Both conditions are terms, which are constant if the types alone determine them.
#pragma once

#include <cstdint>
#include <functional>

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"
#include "ir/interval.hpp"

namespace grafverif::schedule {

/// A total version of a term, in which divisors of 0 are replaced by 1. It is necessary because a model checker also
/// evaluates values that no run uses.
struct Total {
    Id<Expr> term = {};
    /// Condition under which the original is undefined: grafverif::evaluate divides by zero, or the types permit a
    /// value outside 64 bits.
    Id<Expr> undefined = {};
};
Total total(Exprs& exprs, Id<Expr> term, const TypeOf& type_of);

/// Returns the condition under which `term`, which must be total, leaves the range of `type`; false for a Boolean.
Id<Expr> leaves_range(Exprs& exprs, Id<Expr> term, Type type, const TypeOf& type_of);

}  // namespace grafverif::schedule
