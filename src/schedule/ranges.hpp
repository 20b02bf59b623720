// SPDX-License-Identifier: MIT
// Where a value has a place in its variable's range, and where it exists at all: the conditions under which an
// assignment would leave the range of its target or divide by zero. Both are terms, constant where types alone decide.
#pragma once

#include <cstdint>
#include <functional>

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"
#include "ir/interval.hpp"

namespace grafverif::schedule {

/// A term that has a value everywhere: with a divisor of 1 where it divided by zero, for a model checker evaluates what
/// no run does.
struct Total {
    Id<Expr> term = {};
    Id<Expr> undefined = {};  ///< where it had none: evaluated as grafverif::evaluate does, it divides by zero; also
                              ///< where its types let it leave 64 bits
};
Total total(Exprs& exprs, Id<Expr> term, const TypeOf& type_of);

/// The condition under which `term`, which has a value everywhere, leaves the range of `type`; false of a Boolean.
Id<Expr> leaves_range(Exprs& exprs, Id<Expr> term, Type type, const TypeOf& type_of);

}  // namespace grafverif::schedule
