// SPDX-License-Identifier: MIT
// Interval analysis: bounds on the values of a term, derived from the types of its variables.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"

namespace grafverif {

/// Returns the type of the variable of a leaf.
using TypeOf = std::function<Type(const Expr&)>;

struct Interval {
    std::int64_t low = 0, high = 1;
};

/// Returns an interval that contains every value of `term`; its bounds are clipped to 64 bits.
Interval interval(const Exprs& exprs, Id<Expr> term, const TypeOf& type_of);

/// Returns the interval of each term of the table.
std::vector<Interval> intervals(const Exprs& exprs, const TypeOf& type_of);

/// True if a bound of the interval was clipped.
bool is_clipped(const Interval& interval);

/// True if the range does not fit into 32-bit integers.
bool is_wide(std::int64_t low, std::int64_t high);

/// For each term of the table: true if it or a subterm may exceed 32 bits. For such a term, a program with 32-bit
/// arithmetic (NuSMV 2.6, UPPAAL) would silently compute a wrong value.
std::vector<bool> wide_terms(const Exprs& exprs, const TypeOf& type_of);

}  // namespace grafverif
