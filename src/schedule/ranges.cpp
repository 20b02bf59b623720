// SPDX-License-Identifier: MIT
#include "schedule/ranges.hpp"

#include <algorithm>
#include <limits>

#include "support/overloaded.hpp"

namespace grafverif::schedule {

namespace {

/// Returns `condition ? then : otherwise` for Booleans, simplified if an operand is constant.
Id<Expr> either(Exprs& exprs, Id<Expr> condition, Id<Expr> then, Id<Expr> otherwise) {
    if (is_false(exprs, then)) return exprs.conjunction(exprs.negation(condition), otherwise);
    if (is_false(exprs, otherwise)) return exprs.conjunction(condition, then);
    return exprs.conditional(condition, then, otherwise);
}

bool may_be_zero(const Exprs& exprs, Id<Expr> divisor, const TypeOf& type_of) {
    const Interval values = interval(exprs, divisor, type_of);
    return values.low <= 0 && values.high >= 0;
}

std::vector<Id<Expr>> operands_of(const Exprs& exprs, Id<Expr> term) {
    return {exprs.operands(term).begin(), exprs.operands(term).end()};
}

bool divides(Op op) { return op == Op::Divide || op == Op::Modulo; }

bool may_leave_64_bits(const Exprs& exprs, Id<Expr> term, const TypeOf& type_of) {
    if (!is_arithmetic(exprs[term].op)) return false;
    const Interval values = interval(exprs, term, type_of);
    return values.low == std::numeric_limits<std::int64_t>::min() ||
           values.high == std::numeric_limits<std::int64_t>::max();
}

Id<Expr> has_no_value(Exprs& exprs, Id<Expr> term, const TypeOf& type_of) {
    const Op op = exprs[term].op;
    // The term is conservatively assumed to be undefined.
    if (may_leave_64_bits(exprs, term, type_of)) return exprs.constant(true);
    const std::vector<Id<Expr>> operands = operands_of(exprs, term);
    const auto fault = [&](std::size_t i) { return has_no_value(exprs, operands[i], type_of); };
    if (op == Op::Conditional) return exprs.disjunction(fault(0), either(exprs, operands[0], fault(1), fault(2)));
    // The operators `and` and `or` do not evaluate operands after the first operand that determines the result.
    Id<Expr> result = exprs.constant(false);
    for (std::size_t i = operands.size(); i-- > 0;) {
        if ((op == Op::And || op == Op::Or) && !is_false(exprs, result)) {
            const Id<Expr> continues = op == Op::And ? operands[i] : exprs.negation(operands[i]);
            result = exprs.conjunction(continues, result);
        }
        result = exprs.disjunction(fault(i), result);
    }
    if (!divides(op) || !may_be_zero(exprs, operands[1], type_of)) return result;
    return exprs.disjunction(result, exprs.apply(Op::Equal, operands[1], exprs.integer(0)));
}

Id<Expr> with_safe_divisors(Exprs& exprs, Id<Expr> term, const TypeOf& type_of) {
    const Op op = exprs[term].op;
    if (is_leaf(op) || is_constant(op)) return term;
    std::vector<Id<Expr>> operands = operands_of(exprs, term);
    const bool unsafe = divides(op) && may_be_zero(exprs, operands[1], type_of);
    for (Id<Expr>& operand : operands) operand = with_safe_divisors(exprs, operand, type_of);
    if (unsafe) {
        const Id<Expr> zero = exprs.apply(Op::Equal, operands[1], exprs.integer(0));
        operands[1] = exprs.conditional(zero, exprs.integer(1), operands[1]);
    }
    return exprs.apply(op, operands);
}

}  // namespace

Total total(Exprs& exprs, Id<Expr> term, const TypeOf& type_of) {
    const Id<Expr> undefined = with_safe_divisors(exprs, has_no_value(exprs, term, type_of), type_of);
    return {with_safe_divisors(exprs, term, type_of), undefined};
}

Id<Expr> leaves_range(Exprs& exprs, Id<Expr> term, Type range, const TypeOf& type_of) {
    if (range.boolean) return exprs.constant(false);
    const std::vector<Id<Expr>> operands = operands_of(exprs, term);
    if (exprs[term].op == Op::Conditional) {
        const Id<Expr> then = leaves_range(exprs, operands[1], range, type_of);
        return either(exprs, operands[0], then, leaves_range(exprs, operands[2], range, type_of));
    }
    const Interval values = interval(exprs, term, type_of);
    Id<Expr> result = exprs.constant(false);
    if (values.low < range.low) result = exprs.apply(Op::Less, term, exprs.integer(range.low));
    if (values.high > range.high)
        result = exprs.disjunction(result, exprs.apply(Op::Greater, term, exprs.integer(range.high)));
    return result;
}

}  // namespace grafverif::schedule
