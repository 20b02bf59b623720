// SPDX-License-Identifier: MIT
#include "ir/interval.hpp"

#include <algorithm>
#include <limits>

#include "support/overloaded.hpp"

namespace grafverif {

namespace {

constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t greatest = std::numeric_limits<std::int64_t>::max();

std::int64_t sum(std::int64_t a, std::int64_t b) {
    std::int64_t result = 0;
    if (!__builtin_add_overflow(a, b, &result)) return result;
    return a < 0 ? least : greatest;
}

std::int64_t difference(std::int64_t a, std::int64_t b) {
    std::int64_t result = 0;
    if (!__builtin_sub_overflow(a, b, &result)) return result;
    return a < 0 ? least : greatest;
}

std::int64_t product(std::int64_t a, std::int64_t b) {
    std::int64_t result = 0;
    if (!__builtin_mul_overflow(a, b, &result)) return result;
    return (a < 0) == (b < 0) ? greatest : least;
}

Interval product(Interval a, Interval b) {
    const auto [low, high] =
        std::minmax({product(a.low, b.low), product(a.low, b.high), product(a.high, b.low), product(a.high, b.high)});
    return {low, high};
}

std::int64_t magnitude(Interval a) { return std::max(a.high, a.low == least ? greatest : -a.low); }

/// Quotients are truncated towards zero. The magnitude of a quotient is at most the magnitude of the dividend.
Interval quotient(Interval a, Interval b) {
    if (b.low == b.high && b.low > 0) return {a.low / b.low, a.high / b.low};
    const std::int64_t bound = magnitude(a);
    return {-bound, bound};
}

/// A remainder has the sign of the dividend. The magnitude of a remainder is at most the magnitude of the dividend and
/// less than the magnitude of the divisor.
Interval remainder(Interval a, Interval b) {
    const std::int64_t bound = std::min(magnitude(a), std::max<std::int64_t>(magnitude(b) - 1, 0));
    return {a.low < 0 ? -bound : 0, a.high > 0 ? bound : 0};
}

/// Returns the interval of a term, given the intervals of its operands.
template <class OfOperand>
Interval interval_of(const Exprs& exprs, Id<Expr> term, const TypeOf& type_of, const OfOperand& of) {
    const Expr& node = exprs[term];
    if (node.op == Op::Integer || node.op == Op::Duration) return {node.value, node.value};
    if (is_leaf(node.op)) {
        const Type type = type_of(node);
        return {type.low, type.high};
    }
    if (!is_arithmetic(node.op) && node.op != Op::Conditional) return {0, 1};

    const std::span<const Id<Expr>> operands = exprs.operands(term);
    const Interval right = of(operands.back());
    if (node.op == Op::Negate) return {difference(0, right.high), difference(0, right.low)};
    const Interval left = of(operands[operands.size() - 2]);
    switch (node.op) {
    case Op::Plus: return {sum(left.low, right.low), sum(left.high, right.high)};
    case Op::Minus: return {difference(left.low, right.high), difference(left.high, right.low)};
    case Op::Times: return product(left, right);
    case Op::Divide: return quotient(left, right);
    case Op::Modulo: return remainder(left, right);
    case Op::Conditional: return {std::min(left.low, right.low), std::max(left.high, right.high)};
    default: unreachable();
    }
}

}  // namespace

Interval interval(const Exprs& exprs, Id<Expr> term, const TypeOf& type_of) {
    return interval_of(exprs, term, type_of, [&](Id<Expr> operand) { return interval(exprs, operand, type_of); });
}

std::vector<Interval> intervals(const Exprs& exprs, const TypeOf& type_of) {
    std::vector<Interval> all;  // the operands of a term precede it
    for (std::uint32_t index = 0; index < exprs.size(); ++index)
        all.push_back(interval_of(exprs, {index}, type_of, [&](Id<Expr> operand) { return all[operand.index]; }));
    return all;
}

bool is_clipped(const Interval& interval) { return interval.low == least || interval.high == greatest; }

std::vector<bool> terms_with_values(const Exprs& exprs, const std::vector<Interval>& values) {
    std::vector<bool> found;
    for (const Interval& own : values) {
        const Id<Expr> term{static_cast<std::uint32_t>(found.size())};
        const Expr& node = exprs[term];
        const std::span<const Id<Expr>> operands = exprs.operands(term);
        bool has_value = !is_arithmetic(node.op) || !is_clipped(own);
        if (node.op == Op::Divide || node.op == Op::Modulo) {
            const Expr& divisor = exprs[operands[1]];
            has_value = has_value && divisor.op == Op::Integer && divisor.value != 0 && divisor.value != -1;
        }
        found.push_back(has_value &&
                        std::ranges::all_of(operands, [&](Id<Expr> operand) { return found[operand.index]; }));
    }
    return found;
}

bool is_wide(std::int64_t low, std::int64_t high) {
    return low < std::numeric_limits<std::int32_t>::min() || high > std::numeric_limits<std::int32_t>::max();
}

std::vector<bool> wide_terms(const Exprs& exprs, const TypeOf& type_of) {
    std::vector<bool> wide;
    for (const Interval& own : intervals(exprs, type_of)) {
        const Id<Expr> term{static_cast<std::uint32_t>(wide.size())};
        wide.push_back(is_wide(own.low, own.high) || std::ranges::any_of(exprs.operands(term), [&](Id<Expr> operand) {
                           return wide[operand.index];
                       }));
    }
    return wide;
}

}  // namespace grafverif
