// SPDX-License-Identifier: MIT
// Interval: the values that a term can have, as the types of its variables bound them.
#pragma once

#include <cstdint>
#include <functional>

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"

namespace grafverif {

/// The type of the variable with this leaf.
using TypeOf = std::function<Type(const Expr&)>;

struct Interval {
    std::int64_t low = 0, high = 1;
};

/// An interval that holds every value of `term`; bounds outside 64 bits are cut there.
Interval interval(const Exprs& exprs, Id<Expr> term, const TypeOf& type_of);

}  // namespace grafverif
