// SPDX-License-Identifier: MIT
#include "bdd/integers.hpp"

#include <algorithm>
#include <utility>

namespace grafverif::bdd {

namespace {

const Bdd& bit(const Integer& value, std::size_t place) { return value[std::min(place, value.size() - 1)]; }

/// Without the sign bits that only repeat the sign.
Integer trimmed(Integer value) {
    while (value.size() > 1 && value[value.size() - 1] == value[value.size() - 2]) value.pop_back();
    return value;
}

/// left + right + carry over `width` bits, what lies beyond dropped.
Integer added(const Integer& left, const Integer& right, Bdd carry, std::size_t width) {
    Integer result;
    result.reserve(width);
    for (std::size_t place = 0; place < width; ++place) {
        const Bdd either = bit(left, place) ^ bit(right, place);
        result.push_back(either ^ carry);
        carry = ite(either, carry, bit(left, place));
    }
    return result;
}

Integer inverted(const Integer& value) {
    Integer result;
    result.reserve(value.size());
    for (const Bdd& each : value) result.push_back(~each);
    return result;
}

Integer shifted(const Integer& value, std::size_t places) {
    Integer result(places);
    result.insert(result.end(), value.begin(), value.end());
    return result;
}

Integer masked(const Bdd& condition, const Integer& value) {
    Integer result;
    result.reserve(value.size());
    for (const Bdd& each : value) result.push_back(condition & each);
    return result;
}

Integer magnitude(const Integer& value) { return choice(value.back(), negated(value), value); }

}  // namespace

Integer constant(std::int64_t value) {
    Integer result;
    for (; value != 0 && value != -1; value >>= 1) result.push_back(Bdd::constant((value & 1) != 0));
    result.push_back(Bdd::constant(value == -1));
    return result;
}

Integer sum(const Integer& left, const Integer& right) {
    return trimmed(added(left, right, {}, std::max(left.size(), right.size()) + 1));
}

Integer difference(const Integer& left, const Integer& right) {
    return trimmed(added(left, inverted(right), Bdd::constant(true), std::max(left.size(), right.size()) + 1));
}

Integer negated(const Integer& operand) { return difference(constant(0), operand); }

Integer product(const Integer& left, const Integer& right) {
    Integer result = constant(0);
    for (std::size_t place = 0; place < right.size(); ++place) {
        const Integer part = shifted(masked(right[place], left), place);
        result = place + 1 < right.size() ? sum(result, part) : difference(result, part);  // the sign counts negatively
    }
    return result;
}

Division division(const Integer& left, const Integer& right) {
    const Integer dividend = magnitude(left), divisor = magnitude(right);
    Integer remainder = constant(0);
    Integer quotient(dividend.size() + 1);
    for (std::size_t place = dividend.size(); place-- > 0;) {  // long division; the remainder is never negative
        remainder = shifted(remainder, 1);
        remainder.front() = dividend[place];
        const Bdd fits = ~less(remainder, divisor);
        quotient[place] = fits;
        remainder = choice(fits, difference(remainder, divisor), remainder);
    }
    quotient = trimmed(std::move(quotient));
    return {choice(left.back() ^ right.back(), negated(quotient), quotient),
            choice(left.back(), negated(remainder), remainder)};
}

Integer choice(const Bdd& condition, const Integer& then, const Integer& otherwise) {
    Integer result;
    for (std::size_t place = 0; place < std::max(then.size(), otherwise.size()); ++place)
        result.push_back(ite(condition, bit(then, place), bit(otherwise, place)));
    return trimmed(std::move(result));
}

Bdd equal(const Integer& left, const Integer& right) {
    Bdd result = Bdd::constant(true);
    for (std::size_t place = std::max(left.size(), right.size()); place-- > 0 && !result.is_false();)
        result &= iff(bit(left, place), bit(right, place));
    return result;
}

Bdd less(const Integer& left, const Integer& right) {
    const std::size_t width = std::max(left.size(), right.size());
    Bdd result;
    for (std::size_t place = 0; place < width; ++place) {
        const bool sign = place + 1 == width;  // there a one makes a number smaller
        const Bdd& low = sign ? bit(right, place) : bit(left, place);
        const Bdd& high = sign ? bit(left, place) : bit(right, place);
        result = ite(low ^ high, high, result);
    }
    return result;
}

Bdd is_zero(const Integer& operand) { return equal(operand, constant(0)); }

Bdd cut_to_64_bits(Integer& value) {
    Bdd changed;
    for (std::size_t place = 64; place < value.size(); ++place) changed |= value[place] ^ value[63];
    if (value.size() > 64) value.resize(64);
    return changed;
}

}  // namespace grafverif::bdd
