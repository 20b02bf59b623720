// SPDX-License-Identifier: MIT
// Arithmetic on two's complement integers whose bits are Boolean functions. Results of `sum`, `difference` and
// `product` are exact, because a result has more bits than its operands if necessary.
//
// Requirements on Bit, a Boolean function: `Bit()` is the constant false; `Bit::constant`, `is_false`, `==`, `~ & | ^`
// and `ite(condition, then, otherwise)`, which is found by argument-dependent lookup. If `==` returns true, the
// functions are equal; `==` may return false for equal functions.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace grafverif::bits {

/// The bits of an integer: the least significant bit is first, and the sign bit is last; never empty.
template <class Bit>
using Integer = std::vector<Bit>;

template <class Bit>
Integer<Bit> constant(std::int64_t value) {
    Integer<Bit> result;
    for (; value != 0 && value != -1; value >>= 1) result.push_back(Bit::constant((value & 1) != 0));
    result.push_back(Bit::constant(value == -1));
    return result;
}

template <class Bit>
const Bit& bit(const Integer<Bit>& value, std::size_t place) {
    return value[std::min(place, value.size() - 1)];
}

/// Removes redundant copies of the sign bit.
template <class Bit>
Integer<Bit> trimmed(Integer<Bit> value) {
    while (value.size() > 1 && value[value.size() - 1] == value[value.size() - 2]) value.pop_back();
    return value;
}

/// Returns left + right + carry in `width` bits; higher bits are dropped.
template <class Bit>
Integer<Bit> added(const Integer<Bit>& left, const Integer<Bit>& right, Bit carry, std::size_t width) {
    Integer<Bit> result;
    result.reserve(width);
    for (std::size_t place = 0; place < width; ++place) {
        const Bit either = bit(left, place) ^ bit(right, place);
        result.push_back(either ^ carry);
        carry = ite(either, carry, bit(left, place));
    }
    return result;
}

template <class Bit>
Integer<Bit> inverted(const Integer<Bit>& value) {
    Integer<Bit> result;
    result.reserve(value.size());
    for (const Bit& each : value) result.push_back(~each);
    return result;
}

template <class Bit>
Integer<Bit> shifted(const Integer<Bit>& value, std::size_t places) {
    Integer<Bit> result(places);
    result.insert(result.end(), value.begin(), value.end());
    return result;
}

template <class Bit>
Integer<Bit> masked(const Bit& condition, const Integer<Bit>& value) {
    Integer<Bit> result;
    result.reserve(value.size());
    for (const Bit& each : value) result.push_back(condition & each);
    return result;
}

template <class Bit>
Integer<Bit> sum(const Integer<Bit>& left, const Integer<Bit>& right) {
    return trimmed(added(left, right, Bit(), std::max(left.size(), right.size()) + 1));
}

template <class Bit>
Integer<Bit> difference(const Integer<Bit>& left, const Integer<Bit>& right) {
    return trimmed(added(left, inverted(right), Bit::constant(true), std::max(left.size(), right.size()) + 1));
}

template <class Bit>
Integer<Bit> negated(const Integer<Bit>& operand) {
    return difference(constant<Bit>(0), operand);
}

template <class Bit>
Integer<Bit> product(const Integer<Bit>& left, const Integer<Bit>& right) {
    Integer<Bit> result = constant<Bit>(0);
    for (std::size_t place = 0; place < right.size(); ++place) {
        const Integer<Bit> part = shifted(masked(right[place], left), place);
        result = place + 1 < right.size() ? sum(result, part) : difference(result, part);  // sign bit: negative weight
    }
    return result;
}

template <class Bit>
Bit equal(const Integer<Bit>& left, const Integer<Bit>& right) {
    Bit result = Bit::constant(true);
    for (std::size_t place = std::max(left.size(), right.size()); place-- > 0 && !result.is_false();)
        result = result & ~(bit(left, place) ^ bit(right, place));
    return result;
}

template <class Bit>
Integer<Bit> choice(const Bit& condition, const Integer<Bit>& then, const Integer<Bit>& otherwise) {
    Integer<Bit> result;
    for (std::size_t place = 0; place < std::max(then.size(), otherwise.size()); ++place)
        result.push_back(ite(condition, bit(then, place), bit(otherwise, place)));
    return trimmed(std::move(result));
}

template <class Bit>
Bit less(const Integer<Bit>& left, const Integer<Bit>& right) {
    const std::size_t width = std::max(left.size(), right.size());
    Bit result;
    for (std::size_t place = 0; place < width; ++place) {
        const bool sign = place + 1 == width;  // if the sign bits differ, the number with sign bit 1 is smaller
        const Bit& low = sign ? bit(right, place) : bit(left, place);
        const Bit& high = sign ? bit(left, place) : bit(right, place);
        result = ite(low ^ high, high, result);
    }
    return result;
}

template <class Bit>
Integer<Bit> magnitude(const Integer<Bit>& value) {
    return choice(value.back(), negated(value), value);
}

/// Quotient and remainder. The quotient is truncated towards zero as in C; both are unspecified if the divisor is zero.
template <class Bit>
struct Division {
    Integer<Bit> quotient = {}, remainder = {};
};

template <class Bit>
Division<Bit> division(const Integer<Bit>& left, const Integer<Bit>& right) {
    const Integer<Bit> dividend = magnitude(left), divisor = magnitude(right);
    Integer<Bit> remainder = constant<Bit>(0);
    Integer<Bit> quotient(dividend.size() + 1);
    for (std::size_t place = dividend.size(); place-- > 0;) {  // long division; the remainder is never negative
        remainder = shifted(remainder, 1);
        remainder.front() = dividend[place];
        const Bit fits = ~less(remainder, divisor);
        quotient[place] = fits;
        remainder = choice(fits, difference(remainder, divisor), remainder);
    }
    quotient = trimmed(std::move(quotient));
    return {choice(left.back() ^ right.back(), negated(quotient), quotient),
            choice(left.back(), negated(remainder), remainder)};
}

template <class Bit>
Bit is_zero(const Integer<Bit>& operand) {
    return equal(operand, constant<Bit>(0));
}

template <class Bit>
Bit cut_to_64_bits(Integer<Bit>& value) {
    Bit changed;
    for (std::size_t place = 64; place < value.size(); ++place) changed = changed | (value[place] ^ value[63]);
    if (value.size() > 64) value.resize(64);
    return changed;
}

}  // namespace grafverif::bits
