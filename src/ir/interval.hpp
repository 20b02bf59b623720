// SPDX-License-Identifier: MIT
// Interval: the values that a term can have, as the types of its variables bound them.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

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

/// Whether integers of 32 bits do not hold all of these.
bool is_wide(std::int64_t low, std::int64_t high);

/// Per term of the table, whether something in it may need an integer of more than 32 bits. A program that computes with 32
/// (NuSMV 2.6, UPPAAL) finds another value then, and says nothing.
std::vector<bool> wide_terms(const Exprs& exprs, const TypeOf& type_of);

}  // namespace grafverif
