// SPDX-License-Identifier: MIT
#include "grafverif/ir/expr.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace grafverif {
namespace {

struct Terms {
    Exprs exprs = {};
    Id<Expr> a = exprs.leaf(Op::Variable, 0);
    Id<Expr> b = exprs.leaf(Op::Variable, 1);
    Id<Expr> c = exprs.leaf(Op::Variable, 2);
    Id<Expr> yes = exprs.constant(true);
    Id<Expr> no = exprs.constant(false);
};

std::vector<Id<Expr>> operands(const Exprs& exprs, Id<Expr> id) {
    return {exprs.operands(id).begin(), exprs.operands(id).end()};
}

std::optional<std::int64_t> value(const Exprs& exprs, Id<Expr> term, std::vector<std::int64_t> variables) {
    return evaluate(exprs, term, [&](const Expr& leaf) { return variables.at(static_cast<std::size_t>(leaf.value)); });
}

TEST(Exprs, EqualTermsAreTheSameTerm) {
    Terms t;
    EXPECT_EQ(t.exprs.conjunction(t.a, t.b), t.exprs.conjunction(t.a, t.b));
    EXPECT_EQ(t.exprs.apply(Op::Plus, t.a, t.exprs.integer(1)), t.exprs.apply(Op::Plus, t.a, t.exprs.integer(1)));
    EXPECT_EQ(t.exprs.leaf(Op::Variable, 1), t.b);
}

TEST(Exprs, TermsThatDifferInKindOrderOrLeafAreDifferentTerms) {
    Terms t;
    EXPECT_NE(t.exprs.conjunction(t.a, t.b), t.exprs.conjunction(t.b, t.a));
    EXPECT_NE(t.exprs.leaf(Op::Step, 1), t.b);
    EXPECT_NE(t.exprs.integer(1), t.exprs.duration(1));
    EXPECT_NE(t.exprs.at(0, 1), t.exprs.at(1, 0));
    EXPECT_NE(t.exprs.apply(Op::Minus, t.a, t.b), t.exprs.apply(Op::Minus, t.b, t.a));
}

TEST(Exprs, ManyTermsKeepTheirIdentityWhenTheTableGrows) {
    Exprs exprs;
    std::vector<Id<Expr>> sums;
    for (std::uint32_t k = 0; k < 5000; ++k)
        sums.push_back(exprs.apply(Op::Plus, exprs.leaf(Op::Variable, k), exprs.integer(k)));
    const std::size_t size = exprs.size();
    for (std::uint32_t k = 0; k < 5000; ++k)
        ASSERT_EQ(exprs.apply(Op::Plus, exprs.leaf(Op::Variable, k), exprs.integer(k)), sums[k]);
    EXPECT_EQ(exprs.size(), size);
}

TEST(Exprs, OperandsOfTheTableItselfMayBePassedBack) {
    Exprs exprs;
    std::vector<Id<Expr>> leaves;
    for (std::uint32_t k = 0; k < 100; ++k) leaves.push_back(exprs.leaf(Op::Variable, k));
    const Id<Expr> all = exprs.conjunction(leaves);
    const Id<Expr> any = exprs.disjunction(exprs.operands(all));
    EXPECT_EQ(operands(exprs, any), leaves);
}

TEST(Exprs, ConnectivesOfNothingAreTheirNeutralElement) {
    Exprs exprs;
    EXPECT_TRUE(is_true(exprs, exprs.conjunction({})));
    EXPECT_TRUE(is_false(exprs, exprs.disjunction({})));
}

TEST(Exprs, ConnectivesDropNeutralAndRepeatedOperandsAndStopAtAbsorbingOnes) {
    Terms t;
    EXPECT_EQ(t.exprs.conjunction(t.yes, t.a), t.a);
    EXPECT_EQ(t.exprs.conjunction(t.a, t.no), t.no);
    EXPECT_EQ(t.exprs.disjunction(t.no, t.a), t.a);
    EXPECT_EQ(t.exprs.disjunction(t.a, t.yes), t.yes);
    EXPECT_EQ(t.exprs.conjunction(t.a, t.a), t.a);
    const Id<Expr> repeated = t.exprs.disjunction(std::array{t.b, t.a, t.b, t.c, t.a});
    EXPECT_EQ(operands(t.exprs, repeated), (std::vector{t.b, t.a, t.c}));
}

TEST(Exprs, ConnectivesFlattenTheirOwnKindAndKeepTheOrderAsWritten) {
    Terms t;
    const Id<Expr> nested = t.exprs.conjunction(t.exprs.conjunction(t.c, t.b), t.a);
    EXPECT_EQ(operands(t.exprs, nested), (std::vector{t.c, t.b, t.a}));
    const Id<Expr> mixed = t.exprs.conjunction(t.exprs.disjunction(t.c, t.b), t.a);
    EXPECT_EQ(t.exprs[mixed].count, 2U);
}

TEST(Exprs, NegationCancelsItselfAndFoldsConstants) {
    Terms t;
    EXPECT_EQ(t.exprs.negation(t.exprs.negation(t.a)), t.a);
    EXPECT_EQ(t.exprs.negation(t.yes), t.no);
    EXPECT_EQ(t.exprs.negation(t.no), t.yes);
}

TEST(Exprs, AConditionalWithAKnownChoiceIsThatChoice) {
    Terms t;
    EXPECT_EQ(t.exprs.conditional(t.yes, t.b, t.c), t.b);
    EXPECT_EQ(t.exprs.conditional(t.no, t.b, t.c), t.c);
    EXPECT_EQ(t.exprs.conditional(t.a, t.b, t.b), t.b);
    EXPECT_EQ(t.exprs[t.exprs.conditional(t.a, t.b, t.c)].op, Op::Conditional);
}

TEST(Exprs, ConstantArithmeticAndComparisonsAreFolded) {
    Exprs exprs;
    const auto number = [&](std::int64_t n) { return exprs.integer(n); };
    EXPECT_EQ(exprs.apply(Op::Plus, number(2), number(3)), number(5));
    EXPECT_EQ(exprs.apply(Op::Divide, number(-7), number(2)), number(-3));
    EXPECT_EQ(exprs.apply(Op::Modulo, number(-7), number(2)), number(-1));
    EXPECT_EQ(exprs.apply(Op::Negate, std::array{number(4)}), number(-4));
    EXPECT_TRUE(is_true(exprs, exprs.apply(Op::LessEqual, number(3), number(3))));
    EXPECT_TRUE(is_true(exprs, exprs.apply(Op::NotEqual, exprs.constant(true), exprs.constant(false))));
}

TEST(Exprs, AnOperationWithoutValueIsKeptAndHasNone) {
    Exprs exprs;
    const auto greatest = exprs.integer(std::numeric_limits<std::int64_t>::max());
    const auto least = exprs.integer(std::numeric_limits<std::int64_t>::min());
    const std::vector<Id<Expr>> terms{exprs.apply(Op::Plus, greatest, exprs.integer(1)),
                                      exprs.apply(Op::Minus, least, exprs.integer(1)),
                                      exprs.apply(Op::Times, greatest, exprs.integer(2)),
                                      exprs.apply(Op::Divide, exprs.integer(1), exprs.integer(0)),
                                      exprs.apply(Op::Modulo, exprs.integer(1), exprs.integer(0)),
                                      exprs.apply(Op::Divide, least, exprs.integer(-1)),
                                      exprs.apply(Op::Modulo, least, exprs.integer(-1)),
                                      exprs.apply(Op::Negate, std::array{least})};
    for (const Id<Expr> term : terms) {
        EXPECT_TRUE(is_arithmetic(exprs[term].op));
        EXPECT_FALSE(value(exprs, term, {}).has_value());
    }
}

TEST(Evaluate, FollowsEveryOperator) {
    Terms t;
    Exprs& e = t.exprs;
    struct Case {
        Id<Expr> term;
        std::int64_t expected;
    };
    const std::vector<std::int64_t> values{1, 0, 7};  // the values of a, b and c
    for (const Case& one : std::vector<Case>{
             {e.conjunction(t.a, t.b), 0},
             {e.disjunction(t.a, t.b), 1},
             {e.negation(t.b), 1},
             {e.conditional(t.a, t.c, t.b), 7},
             {e.conditional(t.b, t.c, t.a), 1},
             {e.apply(Op::Equal, t.a, t.b), 0},
             {e.apply(Op::NotEqual, t.a, t.b), 1},
             {e.apply(Op::Less, t.c, e.integer(8)), 1},
             {e.apply(Op::LessEqual, t.c, e.integer(7)), 1},
             {e.apply(Op::Greater, t.c, e.integer(7)), 0},
             {e.apply(Op::GreaterEqual, t.c, e.integer(7)), 1},
             {e.apply(Op::Plus, t.c, e.integer(3)), 10},
             {e.apply(Op::Minus, t.c, e.integer(9)), -2},
             {e.apply(Op::Times, t.c, t.c), 49},
             {e.apply(Op::Divide, t.c, e.integer(-2)), -3},
             {e.apply(Op::Modulo, t.c, e.integer(-2)), 1},
             {e.apply(Op::Negate, std::array{t.c}), -7},
         })
        EXPECT_EQ(value(e, one.term, values), one.expected);
}

TEST(Evaluate, SkipsOperandsThatDoNotAffectTheResult) {
    Terms t;
    const Id<Expr> fails = t.exprs.apply(Op::Equal, t.exprs.apply(Op::Divide, t.c, t.b), t.exprs.integer(1));
    EXPECT_EQ(value(t.exprs, t.exprs.conjunction(t.b, fails), {1, 0, 7}), 0);
    EXPECT_EQ(value(t.exprs, t.exprs.disjunction(t.a, fails), {1, 0, 7}), 1);
    EXPECT_EQ(value(t.exprs, t.exprs.conditional(t.a, t.c, t.exprs.apply(Op::Divide, t.c, t.b)), {1, 0, 7}), 7);
    EXPECT_FALSE(value(t.exprs, t.exprs.conjunction(t.a, fails), {1, 0, 7}).has_value());
}

TEST(Translate, ReplacesLeavesAndSimplifiesAgain) {
    Terms t;
    const Id<Expr> term = t.exprs.disjunction(t.exprs.conjunction(t.a, t.b), t.exprs.negation(t.c));
    Exprs to;
    const Id<Expr> copy = translate(t.exprs, term, to, [&](const Expr& leaf) {
        return leaf.value == 2 ? to.constant(true) : to.leaf(Op::Variable, static_cast<std::uint32_t>(leaf.value) + 10);
    });
    EXPECT_EQ(copy, to.conjunction(to.leaf(Op::Variable, 10), to.leaf(Op::Variable, 11)));
}

TEST(Translate, MayCopyWithinOneTable) {
    Terms t;
    Id<Expr> term = t.a;
    for (std::uint32_t k = 0; k < 200; ++k) term = t.exprs.apply(Op::Plus, term, t.exprs.leaf(Op::Variable, k));
    const Id<Expr> same = translate(t.exprs, term, t.exprs, [&](const Expr& leaf) {
        return t.exprs.leaf(leaf.op, static_cast<std::uint32_t>(leaf.value));
    });
    EXPECT_EQ(same, term);
}

TEST(Leaves, AreDistinctAndInOrderOfFirstOccurrence) {
    Terms t;
    const Id<Expr> term = t.exprs.disjunction(t.exprs.conjunction(t.c, t.a), t.exprs.conjunction(t.a, t.b));
    EXPECT_EQ(leaves(t.exprs, term), (std::vector{t.c, t.a, t.b}));
    EXPECT_TRUE(leaves(t.exprs, t.yes).empty());
}

}  // namespace
}  // namespace grafverif
