// SPDX-License-Identifier: MIT
// Conditions under which a value is undefined (division by zero) or outside the range of its variable. Both conditions
// are terms; a condition is constant if the types determine it.
#pragma once

#include <cstdint>
#include <functional>

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"
#include "ir/interval.hpp"

namespace grafverif::schedule {

/// A total version of a term, in which divisors of 0 are replaced by 1. It is necessary because a model checker also
/// evaluates values that do not occur in any run.
struct Total {
    Id<Expr> term = {};
    /// Condition under which the original term is undefined: grafverif::evaluate divides by zero, or the types permit a
    /// value outside 64 bits.
    Id<Expr> undefined = {};
};
Total total(Exprs& exprs, Id<Expr> term, const TypeOf& type_of);

/// Returns the condition under which `term`, which must be total, leaves the range of `type`; false for a Boolean.
Id<Expr> leaves_range(Exprs& exprs, Id<Expr> term, Type type, const TypeOf& type_of);

}  // namespace grafverif::schedule
