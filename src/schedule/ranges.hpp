// SPDX-License-Identifier: MIT
// Conditions under which a value is undefined or outside its variable's range: an assignment would leave the range of
// its target or divide by zero. Both are terms, constant if the types alone determine them.
#pragma once

#include <cstdint>
#include <functional>

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"
#include "ir/interval.hpp"

namespace grafverif::schedule {

/// A total version of a term, with divisors of 0 replaced by 1, because a model checker also evaluates values that no
/// run uses.
struct Total {
    Id<Expr> term = {};
    Id<Expr> undefined = {};  ///< the original is undefined: grafverif::evaluate divides by zero, or the
                              ///< types do not exclude that it leaves 64 bits
};
Total total(Exprs& exprs, Id<Expr> term, const TypeOf& type_of);

/// The condition under which `term`, which must be total, leaves the range of `type`; false for a Boolean.
Id<Expr> leaves_range(Exprs& exprs, Id<Expr> term, Type type, const TypeOf& type_of);

}  // namespace grafverif::schedule
