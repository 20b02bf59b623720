// SPDX-License-Identifier: MIT
#include "syntax/print/dialect.hpp"

#include <gtest/gtest.h>

#include <array>
#include <ostream>

namespace grafverif {
namespace {

struct Terms {
    Exprs exprs = {};
    Id<Expr> a = exprs.leaf(Op::Variable, 0);
    Id<Expr> b = exprs.leaf(Op::Variable, 1);
    Id<Expr> c = exprs.leaf(Op::Variable, 2);

    Id<Expr> op(Op kind, Id<Expr> left, Id<Expr> right) { return exprs.apply(kind, left, right); }
    Id<Expr> negative(Id<Expr> operand) { return exprs.apply(Op::Negate, std::array{operand}); }
    std::string text(Id<Expr> term, Dialect dialect = chart_spelling) const {
        return expr_text(exprs, term, dialect, [](std::ostream& out, const Expr& leaf) {
            if (leaf.op == Op::Timed) out << "3s/X2";
            else out << static_cast<char>('a' + leaf.value);
        });
    }
};

TEST(PrintExpr, UsesTheKeywordsOfEachDialect) {
    Terms t;
    const Id<Expr> term =
        t.exprs.disjunction(t.exprs.conjunction(t.a, t.exprs.negation(t.b)),
                            t.op(Op::Equal, t.op(Op::Modulo, t.c, t.exprs.integer(2)), t.exprs.integer(0)));
    EXPECT_EQ(t.text(term), "(a && !b) || c % 2 == 0");
    EXPECT_EQ(t.text(term, uppaal_spelling), "(a && !b) || c % 2 == 0");
    EXPECT_EQ(t.text(term, plain_spelling), "(a and not b) or c % 2 == 0");
    EXPECT_EQ(t.text(term, latex_spelling), "(a \\wedge \\neg b) \\vee c \\bmod 2 = 0");
    EXPECT_EQ(t.text(term, nusmv_spelling), "(a & !b) | c mod 2 = 0");
}

TEST(PrintExpr, AddsBracketsRequiredByPrecedence) {
    Terms t;
    const Id<Expr> either = t.exprs.disjunction(t.a, t.b);
    EXPECT_EQ(t.text(t.exprs.conjunction(either, t.c)), "(a || b) && c");
    EXPECT_EQ(t.text(t.exprs.negation(either)), "!(a || b)");
    EXPECT_EQ(t.text(t.exprs.negation(t.op(Op::Less, t.a, t.b))), "!(a < b)");
    EXPECT_EQ(t.text(t.op(Op::Times, t.op(Op::Plus, t.a, t.b), t.c)), "(a + b) * c");
    EXPECT_EQ(t.text(t.op(Op::Plus, t.op(Op::Times, t.a, t.b), t.c)), "a * b + c");
}

TEST(PrintExpr, KeepsTheGroupingOfArithmetic) {
    Terms t;
    EXPECT_EQ(t.text(t.op(Op::Minus, t.op(Op::Minus, t.a, t.b), t.c)), "a - b - c");
    EXPECT_EQ(t.text(t.op(Op::Minus, t.a, t.op(Op::Minus, t.b, t.c))), "a - (b - c)");
    EXPECT_EQ(t.text(t.op(Op::Plus, t.a, t.op(Op::Plus, t.b, t.c))), "a + (b + c)");
    EXPECT_EQ(t.text(t.op(Op::Divide, t.a, t.op(Op::Times, t.b, t.c))), "a / (b * c)");
    EXPECT_EQ(t.text(t.op(Op::Divide, t.op(Op::Divide, t.a, t.b), t.c)), "a / b / c");
}

TEST(PrintExpr, ComparisonsDoNotAssociate) {
    Terms t;
    const Id<Expr> equal = t.op(Op::Equal, t.a, t.b);
    EXPECT_EQ(t.text(t.op(Op::Equal, equal, t.c)), "(a == b) == c");
    EXPECT_EQ(t.text(t.op(Op::Equal, t.c, equal)), "c == (a == b)");
    EXPECT_EQ(t.text(t.op(Op::NotEqual, t.exprs.conjunction(t.a, t.b), t.c)), "(a && b) != c");
}

TEST(PrintExpr, NotAndComparisonsAreBracketedBothWaysInPlainText) {
    Terms t;
    EXPECT_EQ(t.text(t.exprs.negation(t.op(Op::Equal, t.a, t.b)), plain_spelling), "not (a == b)");
    EXPECT_EQ(t.text(t.op(Op::Equal, t.exprs.negation(t.a), t.b), plain_spelling), "(not a) == b");
}

TEST(PrintExpr, NegativeNumbersReadLikePrefixedTerms) {
    Terms t;
    EXPECT_EQ(t.text(t.op(Op::Minus, t.a, t.exprs.integer(-1))), "a - -1");
    EXPECT_EQ(t.text(t.negative(t.negative(t.a))), "-(-a)");
    EXPECT_EQ(t.text(t.negative(t.op(Op::Plus, t.a, t.b))), "-(a + b)");
}

TEST(PrintExpr, AConditionalIsBracketedBelowOperatorsAndAlwaysInNusmv) {
    Terms t;
    const Id<Expr> inner = t.exprs.conditional(t.b, t.exprs.integer(1), t.c);
    const Id<Expr> chain = t.exprs.conditional(t.a, t.exprs.integer(0), inner);
    EXPECT_EQ(t.text(chain, uppaal_spelling), "a ? 0 : b ? 1 : c");
    EXPECT_EQ(t.text(chain, nusmv_spelling), "(a ? 0 : (b ? 1 : c))");
    EXPECT_EQ(t.text(t.op(Op::Plus, inner, t.a), uppaal_spelling), "(b ? 1 : c) + a");
    EXPECT_EQ(t.text(t.op(Op::Plus, inner, t.a), nusmv_spelling), "(b ? 1 : c) + a");
    EXPECT_EQ(t.text(t.exprs.conditional(t.a, inner, t.c), uppaal_spelling), "a ? (b ? 1 : c) : c");
}

TEST(PrintExpr, ATimeConditionBindsLikeADivision) {
    Terms t;
    const Id<Expr> timed = t.exprs.leaf(Op::Timed, 0);
    EXPECT_EQ(t.text(t.exprs.negation(timed)), "!(3s/X2)");
    EXPECT_EQ(t.text(t.exprs.conjunction(t.a, timed)), "a && 3s/X2");
}

TEST(PrintExpr, EdgesAreWrittenAsCalls) {
    Terms t;
    EXPECT_EQ(t.text(t.exprs.apply(Op::Rise, std::array{t.exprs.disjunction(t.a, t.b)})), "rise(a || b)");
    EXPECT_EQ(t.text(t.exprs.negation(t.exprs.apply(Op::Fall, std::array{t.a}))), "!fall(a)");
}

TEST(DurationText, PrefersWholeSeconds) {
    EXPECT_EQ(duration_text(3000), "3s");
    EXPECT_EQ(duration_text(250), "250ms");
    EXPECT_EQ(duration_text(1500), "1500ms");
    EXPECT_EQ(duration_text(120000), "120s");
}

}  // namespace
}  // namespace grafverif
