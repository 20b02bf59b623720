// SPDX-License-Identifier: MIT
// Conditions under which a value is undefined (division by zero) or outside the range of its variable. Each condition
// is a term. The term is constant if the types of the variables determine its value.
#pragma once

#include <cstdint>
#include <functional>

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"
#include "ir/interval.hpp"

namespace grafverif::schedule {

/// A total version of a term, in which each divisor with the value 0 is replaced by 1. The total version is necessary,
/// because a model checker also evaluates terms for values that do not occur in any run.
struct Total {
    Id<Expr> term = {};
    /// Condition under which the original term is undefined: a divisor is zero, or the types of the variables permit a
    /// value outside 64 bits.
    Id<Expr> undefined = {};
};
Total total(Exprs& exprs, Id<Expr> term, const TypeOf& type_of);

/// Returns the condition under which the value of `term` is outside the range of `type`; false for a Boolean. Requires
/// that `term` is total.
Id<Expr> leaves_range(Exprs& exprs, Id<Expr> term, Type type, const TypeOf& type_of);

}  // namespace grafverif::schedule
