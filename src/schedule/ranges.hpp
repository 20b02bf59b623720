// SPDX-License-Identifier: MIT
// Where a value has a place in its variable's range, and where it exists at all: the conditions under which an
// assignment would leave the range of its target or divide by zero. Both are terms, constant where types alone decide.
#pragma once

#include <cstdint>
#include <functional>

#include "grafverif/ir/expr.hpp"
#include "ir/interval.hpp"
#include "grafverif/ir/type.hpp"

namespace grafverif::schedule {

/// The condition under which `term`, evaluated as grafverif::evaluate does, divides by zero.
Id<Expr> divides_by_zero(Exprs& exprs, Id<Expr> term, const TypeOf& type_of);

/// `term` with a divisor of 1 where it divided by zero: a model checker evaluates what no run does.
Id<Expr> with_safe_divisors(Exprs& exprs, Id<Expr> term, const TypeOf& type_of);

/// The condition under which the integer `term`, which never divides by zero, has a value outside `range`.
Id<Expr> leaves_range(Exprs& exprs, Id<Expr> term, Type range, const TypeOf& type_of);

}  // namespace grafverif::schedule
