// SPDX-License-Identifier: MIT
// Tests the recognition of NuSMV and UPPAAL formulas, and error locations in other texts.
#include "syntax/print/formula.hpp"

#include <gtest/gtest.h>

#include <string>

namespace grafverif {
namespace {

using enum FormulaLanguage;

/// Returns `begin-end: what`, or an empty string if the text is a formula.
std::string fault_of(FormulaLanguage language, const std::string& text, const FormulaNames& names = {}) {
    const auto fault = formula_fault(language, text, names);
    if (!fault) return {};
    return std::to_string(fault->begin) + "-" + std::to_string(fault->end) + ": " + fault->what;
}

TEST(Formula, AcceptsWhatNusmvAccepts) {
    for (const char* text : {"AG EF press.X_0",
                             "AG (a -> AF b)",
                             "AG a -> b",
                             "!EF !a",
                             "! ! AX a & b",
                             "A [a U b]",
                             "E[a U E [b U c]]",
                             "A [ a BU 0..3 b ]",
                             "EBF 0..7 a",
                             "AG (n = 3 -> AX n = 4)",
                             "n + 2 * m mod 4 >= -1",
                             "press.loc = going_out",
                             "press.loc in {still, moving}",
                             "n in 0..3",
                             "a xor b xnor c <-> d -> e",
                             "(a ? n : m) = 3",
                             "count(a, b, c) = 1",
                             "max(n, abs(m)) < 3 & toint(a) = 1 & bool(n)",
                             "(AX a) <-> b",
                             "\tTRUE ",
                             "A [(a ? b : c) U d]",
                             "AG part_1.n.m != 2"})
        EXPECT_EQ(fault_of(Ctl, text), "") << text;
    for (const char* text : {"G F press.X_0", "G (a -> F b)", "a U b U c", "a S b | O c & H d", "G [0, 3] a", "!X !Y a",
                             "X next(a) = b", "a V b T c", "Z (a & n = 2)"})
        EXPECT_EQ(fault_of(Ltl, text), "") << text;
}

TEST(Formula, AcceptsTheSymbolicQueriesOfUppaal) {
    for (const char* text : {"A[] not deadlock", "E<> Lamp.lit && x >= 3", "A<> a or b imply c", "E[] !a", "a --> b",
                             "A [] (a ? b : c) == 2", "A[] forall (i : int[0, 3]) a[i] <= i && i != 2",
                             "E<> exists (i : int[0,N]) (x[i] >> 1 | 3) == 0", "A[] abs(n - 2) <? 3 < 7",
                             "(a && b) --> (c || d)", "A[] sum (i : int[0,1]) x[i] == 1", "E<> t >= 1.5"})
        EXPECT_EQ(fault_of(Uppaal, text), "") << text;
}

TEST(Formula, ReportsTheLocationOfAnError) {
    struct FormulaCase {
        FormulaLanguage language;
        const char *text, *fault;
    };
    for (const FormulaCase& one : {
             FormulaCase{Ctl, "TRUE; INVAR FALSE", "4-5: `;` would end the formula; write one formula per property"},
             {Ltl, "G a;", "3-4: `;` would end the formula; write one formula per property"},
             {Uppaal, "A[] a; E<> b", "5-6: `;` would end the formula; write one formula per property"},
             {Ctl, "TRUE INVAR FALSE", "5-10: expected an operator or the end of the formula, got `INVAR`"},
             {Ctl, "TRUE IN press", "5-7: expected an operator or the end of the formula, got `IN`"},
             {Ctl, "MODULE", "0-6: expected an operand, got `MODULE`"},
             {Ctl, "", "0-0: expected an operand, got the end"},
             {Ctl, "AG", "2-2: expected an operand, got the end"},
             {Ctl, "a -- b", "2-4: `--` starts a comment, which is not allowed in a formula"},
             {Ctl, "a--b", "0-4: NuSMV reads `a--b` as one name; insert a blank before the operator"},
             {Ctl, "x->y", "0-2: NuSMV reads `x-` as one name; insert a blank before the operator"},
             {Ctl, "/* a", "0-2: `/*` starts a comment, which is not allowed in a formula"},
             {Uppaal, "A[] a // b", "6-8: `//` starts a comment, which is not allowed in a formula"},
             {Uppaal, "A[] a /* b", "6-8: `/*` starts a comment, which is not allowed in a formula"},
             {Ctl, "AG (a & b", "9-9: expected `)`, got the end"},
             {Ctl, "AG a)", "4-5: expected an operator or the end of the formula, got `)`"},
             {Ctl, "A [a U b", "8-8: expected `]`, got the end"},
             {Ctl, "A [a ? b : c U d]", "5-6: expected `U`, got `?`"},
             {Ctl, "F a", "0-1: `F` is an operator of LTL, but the formula is CTL"},
             {Ltl, "AG a", "0-2: `AG` is an operator of CTL, but the formula is LTL"},
             {Ctl, "next(a)", "0-4: `next` is allowed only in LTL, not in CTL"},
             {Ltl, "next(next(a))", "5-9: `next` is not allowed within `next`"},
             {Ctl, "(AX a) = b", "0-6: an operand of `=` contains a path operator"},
             {Ctl, "3", "0-1: expected a condition for a formula, found a number"},
             {Ctl, "AG (n + 1)", "3-10: expected a condition for an operand of `AG`, found a number"},
             {Ctl, "TRUE + 1 = 2", "0-4: expected a number for an operand of `+`, found a condition"},
             {Ctl, "1 = TRUE", "4-8: `=` has a number on one side and a condition on the other"},
             {Ctl, "min(1) = 1", "0-6: `min` takes two operands"},
             {Ctl, "0ub_1 = n", "0-2: a number may contain only digits"},
             {Ctl, "n = 12345678901", "4-15: a number may have at most nine digits"},
             {Ctl, "a\rb", "1-2: byte 0x0D is not allowed in a formula"},
             {Ctl, "a \xC3\xA9", "2-4: `\xC3\xA9` is not allowed in a formula"},
             {Ctl, "case a : b", "0-4: expected an operand, got `case`"},
             {Uppaal, "a", "1-1: a query must start with `A[]`, `A<>`, `E<>` or `E[]`, or have the form `p --> q`"},
             {Uppaal, "A[] x = 3", "6-7: `=` is an assignment; write `==` for equality"},
             {Uppaal, "A[] x++", "5-7: `++` is an assignment; write `==` for equality"},
             {Uppaal, "E[] deadlock", "4-12: `deadlock` is allowed only in `A[]` and `E<>`"},
             {Uppaal, "sup: x", "0-3: expected an operand, got `sup`"},
             {Uppaal, "A[] a --> b", "6-9: expected an operator or the end of the formula, got `-->`"},
             {Uppaal, "A[] </formula>", "4-5: expected an operand, got `<`"},
             {Uppaal, "A[] (a", "6-6: expected `)`, got the end"},
             {Uppaal, "control: A[] a", "0-7: expected an operand, got `control`"},
         })
        EXPECT_EQ(fault_of(one.language, one.text), one.fault) << one.text;
}

TEST(Formula, NestingIsBounded) {
    for (const char* open : {"(", "!", "AG ", "- ", "A [", "a ? b : "}) {
        std::string text;
        for (int i = 0; i < 100'000; ++i) text += open;
        EXPECT_NE(fault_of(Ctl, text + "a").find("nested deeper than 200"), std::string::npos) << open;
    }
    std::string text = "A[] ";
    for (int i = 0; i < 100'000; ++i) text += "(";
    EXPECT_NE(fault_of(Uppaal, text).find("nested deeper than 200"), std::string::npos);
    std::string flat = "a";
    for (int i = 0; i < 10'000; ++i) flat += " & a";
    EXPECT_EQ(fault_of(Ctl, flat), "") << "a long conjunction is not nested";
}

TEST(Formula, NamesAndTheirTypesAreThoseOfTheModel) {
    const FormulaNames names = [](std::string_view name) -> std::optional<FormulaName> {
        using Type = FormulaName::Type;
        if (name == "press.X_0") return FormulaName{Type::Boolean, false};
        if (name == "n") return FormulaName{Type::Number, false};
        if (name == "press.loc" || name == "out") return FormulaName{Type::Value, false};
        if (name == "move") return FormulaName{Type::Boolean, true};
        return std::nullopt;
    };
    EXPECT_EQ(fault_of(Ctl, "AG (press.X_0 -> EF (n = 3 & press.loc = out))", names), "");
    EXPECT_EQ(fault_of(Ltl, "G F move", names), "");
    EXPECT_EQ(fault_of(Ctl, "AG press.X_1", names), "3-12: the model does not declare `press.X_1`");
    EXPECT_EQ(fault_of(Ctl, "AG move", names),
              "3-7: the value of `move` is chosen in each step, so it is allowed only in LTL, not in CTL");
    EXPECT_EQ(fault_of(Ctl, "AG n", names), "3-4: expected a condition for an operand of `AG`, found a number");
    EXPECT_EQ(fault_of(Ctl, "AG press.loc = n", names),
              "15-16: `=` has a named value on one side and a number on the other");
    EXPECT_EQ(fault_of(Ctl, "press.loc > 1", names),
              "0-9: expected a number for an operand of `>`, found a named value");
    EXPECT_EQ(fault_of(Uppaal, "A[] forall (i : int[0, n]) i < n && press.X_0", names), "");
    EXPECT_EQ(fault_of(Uppaal, "A[] forall (i : int[0, n]) i < m", names), "31-32: the model does not declare `m`");
    EXPECT_EQ(fault_of(Uppaal, "E<> i", names), "4-5: the model does not declare `i`");
}

}  // namespace
}  // namespace grafverif
