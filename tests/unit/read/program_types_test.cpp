// SPDX-License-Identifier: MIT
// Tests PLC programs: arrays, structures, subranges, bit strings, durations, VAR_IN_OUT and actions.
#include <gtest/gtest.h>

#include "unit/read/program_values.hpp"

namespace grafverif {
namespace {

std::string program(const std::string& variables, const std::string& body, const std::string& before = "") {
    return before + "PROGRAM p VAR_INPUT e : INT; END_VAR VAR n : INT; " + variables + " END_VAR\n" + body +
           "\nEND_PROGRAM";
}

/// Returns the number of the scan with the first fault of a kind, or 0 if there is no such fault.
std::size_t fault(const std::string& text, ProgramFault kind, const std::vector<std::vector<std::int64_t>>& inputs) {
    const ReadProgram reading(text);
    EXPECT_EQ(reading.codes(), "");
    if (!reading.text) return 0;
    ProgramRun run(reading.text->program());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        run.scan(inputs[i], 10);
        if (!run.fault()) continue;
        EXPECT_EQ(run.fault()->kind, kind);
        return i + 1;
    }
    return 0;
}

TEST(ProgramTypes, ManyLevelsAreRejected) {
    const auto chain = [](int levels) {
        std::string text = "TYPE\n";
        for (int k = 0; k < levels; ++k)
            text += "T" + std::to_string(k) + " : STRUCT m : T" + std::to_string(k + 1) + "; END_STRUCT;\n";
        return text + "T" + std::to_string(levels) + " : INT; END_TYPE\n" + program("t : T0;", "n := 1;");
    };
    EXPECT_EQ(ReadProgram(chain(50)).codes(), "");
    EXPECT_NE(ReadProgram(chain(20'000)).codes().find("not-in-program"), std::string::npos);
}

TEST(ProgramTypes, AnIndexSelectsAnElementOrIsAFault) {
    const std::string text = program("a : ARRAY[-1..2] OF INT; m : ARRAY[0..1, 1..2] OF INT;",
                                     "a[e] := a[e] + 5; m[1, 2] := a[-1]; m[1][1] := 7; n := a[0] + m[1, e + 1];");
    EXPECT_EQ(values(text, "n", {{0}, {0}, {1}}), "12 17 10");
    EXPECT_EQ(values(text, "a[1]", {{0}, {1}, {1}}), "0 5 10");
    EXPECT_EQ(fault(text, ProgramFault::ArrayBounds, {{0}, {1}, {3}}), 3U);
    EXPECT_EQ(ReadProgram(program("a : ARRAY[1..2] OF INT;", "n := a[3];\nn := a;\nn := n[1];")).codes(),
              "2:8 not-in-program\n3:6 not-in-program\n4:6 type-mismatch\n");
    EXPECT_EQ(ReadProgram(program("a : ARRAY[2..1] OF INT;\nb : ARRAY[e..3] OF INT;", "")).codes(),
              "1:51 not-in-program\n2:11 not-constant\n");
}

TEST(ProgramTypes, InstancesInArraysKeepTheirValues) {
    EXPECT_EQ(
        values(program("t : ARRAY[0..1] OF TON;", "t[e](IN := TRUE, PT := T#15ms); IF t[0].Q THEN n := 1; END_IF"), "n",
               {{0}, {1}, {0}}),
        "0 0 1");
}

TEST(ProgramTypes, StructuresAreAssignedByMemberAndCompletely) {
    const std::string types =
        "TYPE Point : STRUCT x, y : INT := 3; END_STRUCT; Line : STRUCT a, b : Point; END_STRUCT; END_TYPE\n";
    EXPECT_EQ(values(program("l : Line; q : ARRAY[0..1] OF Point;",
                             "l.a.x := e; q[0] := l.a; q[e] := q[0]; l.b := q[1]; n := l.b.x + l.b.y;", types),
                     "n", {{0}, {1}}),
              "6 4");
    EXPECT_EQ(ReadProgram(program("l : Line; q : Point;", "l := q;\nn := q.z;\nq := 1;", types)).codes(),
              "3:1 type-mismatch\n4:6 unknown-variable\n5:6 not-in-program\n");
}

TEST(ProgramTypes, TypesCanReferToLaterTypesAndBlocks) {
    const std::string types =
        "TYPE Line : STRUCT a, b : Point; t : TON; END_STRUCT; Points : ARRAY[0..1] OF Point; Mode : Kind;\n"
        "Point : STRUCT x, y : INT := 3; END_STRUCT; Kind : (Off, On); END_TYPE\n";
    const std::string body = "l.a.x := e; l.t(IN := TRUE, PT := T#15ms); IF l.t.Q AND m = Off THEN n := l.a.x; END_IF";
    EXPECT_EQ(values(program("l : Line; m : Mode; p : Points;", body, types), "n", {{1}, {2}, {3}}), "0 0 3");
}

TEST(ProgramTypes, RecursiveTypesAreRejectedOnce) {
    EXPECT_EQ(ReadProgram(program("s : S;", "",
                                  "TYPE S : STRUCT t : T; END_STRUCT;\nT : STRUCT s : S; END_STRUCT; "
                                  "END_TYPE\n"))
                  .codes(),
              "2:16 recursive-unit\n");
    EXPECT_EQ(ReadProgram(program("s : A;", "", "TYPE A : B; B : A; END_TYPE\n")).codes(), "1:17 recursive-unit\n");
    EXPECT_EQ(ReadProgram(program("s : A;", "", "TYPE A : INT; a : BOOL; INT : BOOL; END_TYPE\n")).codes(),
              "1:15 duplicate-name\n1:25 duplicate-name\n");
}

TEST(ProgramTypes, QualifiedValuesOfEnumerationsAreLabels) {
    const std::string types = "TYPE Mode3_t : (Off, On); END_TYPE\n";
    const std::string body = "CASE m OF\nMode3_t#Off: n := 5; m := Mode3_t#On;\nMode3_t#On: n := 7;\nEND_CASE";
    EXPECT_EQ(values(program("m : Mode3_t;", body, types), "n", {{0}, {0}}), "5 7");
}

TEST(ProgramTypes, ExtensionsOfTheStandardCauseWarnings) {
    const std::string text = program("", "IF e = 1 THEN n := 1;\nELSEIF e = 2 THEN n := 2; END_IF");
    EXPECT_EQ(ReadProgram(text).codes(), "3:1 not-standard\n");
    EXPECT_EQ(values(text, "n", {{1}, {2}, {3}}), "1 2 2");
    const std::string block =
        "FUNCTION_BLOCK TON VAR_INPUT IN : INT; END_VAR VAR_OUTPUT Q : INT; END_VAR Q := IN + 1; END_FUNCTION_BLOCK\n";
    const std::string own = program("t : TON;", "t(IN := e);\nn := t.Q;", block);
    EXPECT_EQ(ReadProgram(own).codes(), "1:16 not-standard\n");
    EXPECT_EQ(values(own, "n", {{1}, {4}}), "2 5");
    EXPECT_EQ(ReadProgram("PROGRAM p VAR_INPUT a : BOOL; END_VAR INITIAL_STEP S: END_STEP STEP U: END_STEP\n"
                          "TRANSITION FROM S TO U := a; END_TRANSITION TRANSITION FROM U TO S := a; END_TRANSITION\n"
                          "END_PROGRAM\n" +
                          block)
                  .codes(),
              "4:16 duplicate-name\n");
}

TEST(ProgramTypes, RetainedVariablesAreNoted) {
    EXPECT_TRUE(ReadProgram(program("END_VAR VAR RETAIN r : INT;", "")).text->program().retains);
    EXPECT_TRUE(ReadProgram(program("END_VAR VAR CONSTANT PERSISTENT r : INT := 1;", "")).text->program().retains);
    EXPECT_FALSE(ReadProgram(program("END_VAR VAR NON_RETAIN r : INT;", "")).text->program().retains);
}

TEST(ProgramTypes, UnknownNamesAreReportedAsWritten) {
    const ReadProgram reading(program("t : TON;", "n := q + T.qq;"));
    ASSERT_EQ(reading.diagnostics.all().size(), 2U);
    EXPECT_NE(reading.diagnostics.all()[0].message.find("`q`"), std::string::npos);
    EXPECT_NE(reading.diagnostics.all()[1].message.find("`qq`"), std::string::npos);
}

TEST(ProgramTypes, ValuesOutsideOfSubrangesAreFaults) {
    const std::string text = program("s : INT(-3..10); u : INT(2..4);", "s := e; n := s + u;");
    EXPECT_EQ(values(text, "n", {{-3}, {10}}), "-1 12");
    EXPECT_EQ(fault(text, ProgramFault::Range, {{10}, {11}}), 2U);
    EXPECT_EQ(ReadProgram(program("s : INT(1..3);", "s := 4;")).codes(), "2:1 out-of-range\n");
}

TEST(ProgramTypes, BitStringsHaveOperatorsShiftsAndRotations) {
    const auto value = [](const std::string& term) {
        return values(program("w : WORD; b : BYTE := 16#A5;", "w := " + term + ";"), "w", {{0}});
    };
    EXPECT_EQ(value("b AND 16#0F"), "5");
    EXPECT_EQ(value("b OR w"), "165");
    EXPECT_EQ(value("b XOR b XOR w"), "0");
    EXPECT_EQ(value("NOT b"), "90");
    EXPECT_EQ(value("SHL(b, 1)"), "74");
    EXPECT_EQ(value("SHR(b, 9)"), "0");
    EXPECT_EQ(value("ROL(b, 9)"), "75");
    EXPECT_EQ(value("ROR(b, 1)"), "210");
}

TEST(ProgramTypes, DurationsAreAddedAndScaledWithinTheirRange) {
    const std::string text =
        program("t : TIME := T#10ms;", "t := (t + T#5ms) * 2 - T#10ms; n := DINT_TO_INT(TIME_TO_DINT(t / 4));");
    EXPECT_EQ(values(text, "n", {{0}, {0}}), "5 10");
    EXPECT_EQ(fault(program("t : TIME;", "t := t - T#1ms;"), ProgramFault::Range, {{0}}), 1U);
}

TEST(ProgramTypes, LazyOperatorsSkipTheSecondOperand) {
    const std::string text =
        program("x : BOOL;", "x := e <> 0 AND_THEN 10 / e > 2; IF x OR_ELSE 5 / (e + 1) > 4 THEN n := n + 1; END_IF");
    EXPECT_EQ(values(text, "n", {{0}, {3}, {5}}), "1 2 2");
    EXPECT_EQ(fault(program("x : BOOL;", "x := e <> 0 AND 10 / e > 2;"), ProgramFault::DivisionByZero, {{0}}), 1U);
}

TEST(ProgramTypes, InOutVariablesAreThoseOfTheCaller) {
    const std::string block =
        "FUNCTION_BLOCK swap VAR_IN_OUT a, b : INT; END_VAR VAR t : INT; END_VAR t := a; a := b; b := t + 1; "
        "END_FUNCTION_BLOCK\nVAR_GLOBAL g : INT; END_VAR\n";
    EXPECT_EQ(values(program("s : swap; m : INT := 7;", "s(a := n, b := m);", block), "n", {{0}, {0}, {0}}), "7 1 8");
    EXPECT_EQ(ReadProgram(program("s : swap;", "s(a := n, b := n);\ns(a := n);\ns(a := g, b := n);\nn := s.a;", block))
                  .codes(),
              "4:11 not-in-program\n5:1 not-in-program\n6:8 not-in-program\n7:6 unknown-variable\n");
}

TEST(ProgramTypes, ActionsWorkOnTheVariablesOfTheirInstance) {
    const std::string block =
        "FUNCTION_BLOCK lamp VAR_OUTPUT on : BOOL; count : INT; END_VAR\n"
        "ACTION switch_on: on := TRUE; count := count + 1; END_ACTION\n"
        "ACTION switch: IF on THEN on := FALSE; RETURN; END_IF; switch_on(); END_ACTION\nEND_FUNCTION_BLOCK\n";
    EXPECT_EQ(values(program("l, k : lamp;", "l.switch(); IF l.on THEN k.switch_on(); END_IF n := k.count;", block),
                     "n", {{0}, {0}, {0}}),
              "1 1 2");
    EXPECT_EQ(ReadProgram("FUNCTION_BLOCK f ACTION a: b(); END_ACTION ACTION b: a(); END_ACTION END_FUNCTION_BLOCK\n" +
                          program("k : f;", "k.c();"))
                  .codes(),
              "3:1 unknown-variable\n1:25 recursive-unit\n");
}

TEST(ProgramTypes, AFunctionBlockAloneIsExecutedAsAProgram) {
    EXPECT_EQ(values("FUNCTION_BLOCK f VAR_INPUT e : INT; END_VAR VAR_OUTPUT n : INT; END_VAR n := n + e; "
                     "END_FUNCTION_BLOCK",
                     "n", {{2}, {3}}),
              "2 5");
}

TEST(ProgramTypes, WhatTheStandardDoesNotDefineIsAWarning) {
    const ReadProgram reading(
        "PROGRAM p VAR_INPUT e : INT; END_VAR VAR x : BOOL; END_VAR\nINITIAL_STEP S0: act(N); END_STEP\n"
        "STEP S1: END_STEP\nTRANSITION FROM S0 TO S1 := e; END_TRANSITION\nACTION act: x := e != 2; END_ACTION\n"
        "END_PROGRAM");
    EXPECT_EQ(reading.codes(), "5:20 not-standard\n4:29 not-standard\n");
    EXPECT_TRUE(reading.text);
}

}  // namespace
}  // namespace grafverif
