// SPDX-License-Identifier: MIT
// Interval analysis: bounds on the values of a term, derived from the types of its variables.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"

namespace grafverif {

/// A function that returns the type of the variable of a leaf.
using TypeOf = std::function<Type(const Expr&)>;

struct Interval {
    std::int64_t low = 0, high = 1;
};

/// Returns an interval that contains every value of `term`. Bounds outside the range of 64-bit integers are replaced by
/// the limits of this range (clipped).
Interval interval(const Exprs& exprs, Id<Expr> term, const TypeOf& type_of);

/// Returns the interval of each term of the table.
std::vector<Interval> intervals(const Exprs& exprs, const TypeOf& type_of);

/// True if a bound of the interval is a limit of the range of 64-bit integers, so that the bound may have been clipped.
bool is_clipped(const Interval& interval);

/// For each term of the table: true if the analysis shows that the term always has a value. Divisors must be constants.
/// `values` is the result of `intervals`.
std::vector<bool> terms_with_values(const Exprs& exprs, const std::vector<Interval>& values);

/// True if the range [low, high] does not fit into 32-bit integers.
bool is_wide(std::int64_t low, std::int64_t high);

/// For each term of the table: true if the value of the term or of a subterm may exceed 32 bits. For a term with the
/// result true, a program with 32-bit arithmetic (NuSMV 2.6, UPPAAL) may silently compute a wrong value.
std::vector<bool> wide_terms(const Exprs& exprs, const TypeOf& type_of);

}  // namespace grafverif
