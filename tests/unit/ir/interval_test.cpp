// SPDX-License-Identifier: MIT
#include "ir/interval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/random_chart.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

/// Random integer terms and the types of their variables. Ranges and constants are small, near the limits of 32 bits,
/// or beyond.
struct IntegerTerms {
    Exprs exprs = {};
    std::vector<Type> types = {};

    Type type_of(const Expr& leaf) const { return types[static_cast<std::size_t>(leaf.value)]; }
};

std::int64_t some_number(Random& random) {
    const std::int64_t size = std::int64_t{1} << random_number(random, 0, 33);
    return random_number(random, -size, size);
}

Id<Expr> random_term(IntegerTerms& terms, Random& random, int depth) {
    if (depth == 0 || chance(random, 15))
        return chance(random, 30) ? terms.exprs.integer(some_number(random))
                                  : terms.exprs.leaf(Op::Variable, static_cast<std::uint32_t>(random_number(
                                                                       random, 0, std::ssize(terms.types) - 1)));
    const auto operand = [&] { return random_term(terms, random, depth - 1); };
    const Id<Expr> one = operand(), other = operand();
    switch (random_number(random, 0, 6)) {
    case 0: return terms.exprs.apply(Op::Plus, one, other);
    case 1: return terms.exprs.apply(Op::Minus, one, other);
    case 2: return terms.exprs.apply(Op::Times, one, other);
    case 3: return terms.exprs.apply(Op::Divide, one, terms.exprs.integer(random_number(random, 1, 9)));
    case 4: return terms.exprs.apply(Op::Modulo, one, terms.exprs.integer(random_number(random, 1, 9)));
    case 5: return terms.exprs.apply(Op::Negate, std::vector{one});
    default: return terms.exprs.conditional(terms.exprs.apply(Op::Less, one, other), one, other);
    }
}

/// Returns the result of a program that truncates each value to 32 bits.
std::int64_t computed_with_32_bits(const Exprs& exprs, Id<Expr> term, const std::vector<std::int64_t>& values) {
    const Expr& node = exprs[term];
    const auto of = [&](std::size_t k) { return computed_with_32_bits(exprs, exprs.operands(term)[k], values); };
    const auto kept = [](std::int64_t value) -> std::int64_t { return static_cast<std::int32_t>(value); };
    switch (node.op) {
    case Op::Integer: return kept(node.value);
    case Op::Variable: return kept(values[static_cast<std::size_t>(node.value)]);
    case Op::Negate: return kept(-of(0));
    case Op::Plus: return kept(of(0) + of(1));
    case Op::Minus: return kept(of(0) - of(1));
    case Op::Times: return kept(of(0) * of(1));
    case Op::Divide: return kept(of(0) / of(1));
    case Op::Modulo: return kept(of(0) % of(1));
    case Op::Less: return of(0) < of(1) ? 1 : 0;
    case Op::Conditional: return of(0) != 0 ? of(1) : of(2);
    case Op::False: return 0;
    default: return 1;
    }
}

TEST(Interval, TermsThatAreNotWideAreTheSameWith32Bits) {
    int narrow = 0, wide_and_other = 0;
    for (int seed = 1; seed <= test_size(2000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        IntegerTerms terms;
        for (int k = 0; k < 3; ++k) {
            const std::int64_t one = some_number(random), other = some_number(random);
            terms.types.push_back(integer_type(std::min(one, other), std::max(one, other)));
        }
        const Id<Expr> term = random_term(terms, random, 3);
        const bool wide = wide_terms(terms.exprs, [&](const Expr& leaf) { return terms.type_of(leaf); })[term.index];
        narrow += wide ? 0 : 1;
        bool other = false;
        for (int k = 0; k < 20; ++k) {
            std::vector<std::int64_t> values;
            for (const Type& type : terms.types) values.push_back(random_number(random, type.low, type.high));
            const auto exact = evaluate(terms.exprs, term,
                                        [&](const Expr& leaf) { return values[static_cast<std::size_t>(leaf.value)]; });
            const std::int64_t found = computed_with_32_bits(terms.exprs, term, values);
            other = other || exact != found;
            if (!wide) {
                EXPECT_EQ(exact, found) << "seed " << seed;
            }
        }
        wide_and_other += wide && other ? 1 : 0;
    }
    EXPECT_GT(narrow, test_size(400));
    EXPECT_GT(wide_and_other, test_size(400));
}

}  // namespace
}  // namespace grafverif
