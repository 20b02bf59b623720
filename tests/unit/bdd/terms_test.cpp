// SPDX-License-Identifier: MIT
// Tests terms as Boolean functions, in comparison with `evaluate` under every assignment.
#include "bdd/terms.hpp"

#include <gtest/gtest.h>

#include "support/random_chart.hpp"

namespace grafverif {
namespace {

/// Two Booleans and three small integers; one of the integers has a single value.
const std::vector<Type> types = {{}, {}, integer_type(-3, 4), integer_type(0, 5), integer_type(7, 7)};

struct World {
    Exprs exprs = {};
    BddSpace space{};
    std::vector<BddWord> words = {};

    World() {
        for (const Type type : types) {
            const std::uint32_t first = space.add_variables(bit_count(type));
            BddWord word{type, {}};
            for (std::uint32_t bit = 0; bit < bit_count(type); ++bit) word.bits.push_back(first + bit);
            words.push_back(word);
        }
    }

    BddTerm leaf(const Expr& node) const { return term_of(space, words[static_cast<std::size_t>(node.value)]); }

    Id<Expr> random_integer(Random& random, int depth) {
        if (depth == 0 || chance(random, 20)) {
            if (chance(random, 30)) return exprs.integer(random_number(random, -4, 9));
            return exprs.leaf(Op::Variable, static_cast<std::uint32_t>(random_number(random, 2, 4)));
        }
        const auto operand = [&] { return random_integer(random, depth - 1); };
        switch (random_number(random, 0, 6)) {
        case 0: return exprs.apply(Op::Plus, operand(), operand());
        case 1: return exprs.apply(Op::Minus, operand(), operand());
        case 2: return exprs.apply(Op::Times, operand(), operand());
        case 3: return exprs.apply(Op::Divide, operand(), operand());
        case 4: return exprs.apply(Op::Modulo, operand(), operand());
        case 5: return exprs.apply(Op::Negate, std::vector{operand()});
        default: return exprs.conditional(random_boolean(random, depth - 1), operand(), operand());
        }
    }

    Id<Expr> random_boolean(Random& random, int depth) {
        if (depth == 0 || chance(random, 20))
            return exprs.leaf(Op::Variable, static_cast<std::uint32_t>(random_number(random, 0, 1)));
        const auto operand = [&] { return random_boolean(random, depth - 1); };
        const auto number = [&] { return random_integer(random, depth - 1); };
        switch (random_number(random, 0, 5)) {
        case 0: return exprs.conjunction(operand(), operand());
        case 1: return exprs.disjunction(operand(), operand());
        case 2: return exprs.negation(operand());
        case 3: return exprs.apply(Op::Equal, operand(), operand());
        default: {
            const Op ops[] = {Op::Equal, Op::NotEqual, Op::Less, Op::LessEqual, Op::Greater, Op::GreaterEqual};
            return exprs.apply(ops[random_number(random, 0, 5)], number(), number());
        }
        }
    }
};

void expect_same(const World& world, Id<Expr> root, const BddTerm& term) {
    for (unsigned n = 0; n < 1U << world.space.variables(); ++n) {
        std::vector<bool> values(world.space.variables());
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = ((n >> i) & 1U) != 0;
        const auto expected = evaluate(world.exprs, root, [&](const Expr& node) {
            return value_of(world.words[static_cast<std::size_t>(node.value)], values);
        });
        ASSERT_EQ(!evaluate(term.undefined, values), expected.has_value()) << n;
        if (!expected) continue;
        ASSERT_EQ(value_of(term, values), *expected) << n;
        const std::int64_t other = term.boolean ? 1 - *expected : *expected ^ 1;
        ASSERT_TRUE(evaluate(equals(term, *expected), values)) << n;
        ASSERT_FALSE(evaluate(equals(term, other), values)) << n;
    }
}

TEST(BddTerms, RandomTermsHaveTheValuesThatEvaluateGives) {
    Random random(7);
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(i);
        World world;
        const Id<Expr> root = chance(random, 50) ? world.random_boolean(random, 4) : world.random_integer(random, 3);
        BddTerms terms(world.exprs, [&](const Expr& node) { return world.leaf(node); });
        expect_same(world, root, terms(root));
        if (HasFatalFailure()) return;
    }
}

TEST(BddTerms, ResultsOutside64BitsAreUndefined) {
    World world;
    Id<Expr> power = world.exprs.leaf(Op::Variable, 3);  // the value of this variable is from 0 to 5
    for (int i = 0; i < 4; ++i) power = world.exprs.apply(Op::Times, power, power);  // this computes the 16th power
    const Id<Expr> more = world.exprs.apply(Op::Times, power, power);  // the 32nd power of 5 exceeds 64 bits
    BddTerms terms(world.exprs, [&](const Expr& node) { return world.leaf(node); });
    expect_same(world, more, terms(more));
    EXPECT_FALSE(terms(more).undefined.is_false());
    EXPECT_TRUE(terms(power).undefined.is_false());
}

TEST(BddTerms, WordsEncodeTheValuesOfTheirRange) {
    World world;
    const BddWord& word = world.words[2];  // the range is from -3 to 4
    ASSERT_EQ(word.bits.size(), 3u);
    Bdd any;
    for (std::int64_t value = -3; value <= 4; ++value) {
        EXPECT_EQ(equals(world.space, word, value), equal(term_of(world.space, word), bdd_integer(value))) << value;
        any |= equals(world.space, word, value);
    }
    EXPECT_EQ(any, in_range(world.space, word));
    EXPECT_FALSE(in_range(world.space, world.words[3]).is_true()) << "three bits can represent more values than 0 to 5";
    EXPECT_TRUE(in_range(world.space, world.words[4]).is_true()) << "a word without bits has one value";
    EXPECT_TRUE(equal(term_of(world.space, world.words[4]), bdd_integer(7)).is_true());
}

TEST(BddTerms, DeepTermDoesNotOverflowTheStack) {
    Exprs exprs;
    BddSpace space;
    space.add_variables(1);
    const Id<Expr> leaf = exprs.leaf(Op::Variable, 0);
    Id<Expr> root = leaf;
    for (int i = 0; i < 200'000; ++i)
        root = exprs.conditional(root, exprs.apply(Op::Equal, leaf, root), exprs.constant(i % 2 == 0));
    BddTerms terms(exprs, [&](const Expr&) { return bdd_boolean(space.variable(0)); });
    EXPECT_LE(size(terms(root).bits.front()), 1u);
}

}  // namespace
}  // namespace grafverif
