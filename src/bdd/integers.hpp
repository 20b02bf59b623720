// SPDX-License-Identifier: MIT
// Arithmetic on integers in two's complement whose bits are functions. Results are exact and as wide as they need.
#pragma once

#include <cstdint>
#include <vector>

#include "bdd/bdd.hpp"

namespace grafverif::bdd {

/// Least significant bit first, the last the sign; never empty.
using Integer = std::vector<Bdd>;

Integer constant(std::int64_t value);
Integer sum(const Integer& left, const Integer& right);
Integer difference(const Integer& left, const Integer& right);
Integer negated(const Integer& operand);
Integer product(const Integer& left, const Integer& right);

/// Truncated towards zero, as in C; where the divisor is 0 they mean nothing.
struct Division {
    Integer quotient = {}, remainder = {};
};
Division division(const Integer& left, const Integer& right);

Integer choice(const Bdd& condition, const Integer& then, const Integer& otherwise);

Bdd equal(const Integer& left, const Integer& right);
Bdd less(const Integer& left, const Integer& right);
Bdd is_zero(const Integer& operand);

/// Cuts `value` to 64 bits; where that changes it.
Bdd cut_to_64_bits(Integer& value);

}  // namespace grafverif::bdd
