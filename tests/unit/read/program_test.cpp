// SPDX-License-Identifier: MIT
// Tests PLC programs: values scan by scan, standard blocks, and diagnostics of rejected elements.
#include "read/program/program.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "derive/program/scan.hpp"
#include "run/program/interpreter.hpp"
#include "unit/read/program_values.hpp"

namespace grafverif {
namespace {

std::string block(const std::string& type, const std::string& call) {
    return "PROGRAM p VAR_INPUT a, b : BOOL; END_VAR VAR k : " + type + "; END_VAR\nk(" + call + ");\nEND_PROGRAM";
}

TEST(Program, BistablesAndEdgesFollowTheStandard) {
    EXPECT_EQ(values(block("SR", "S1 := a, R := b"), "k.Q1", {{0, 0}, {1, 0}, {0, 0}, {1, 1}, {0, 1}}), "0 1 1 1 0");
    EXPECT_EQ(values(block("RS", "S := a, R1 := b"), "k.Q1", {{0, 0}, {1, 0}, {0, 0}, {1, 1}, {0, 1}}), "0 1 1 0 0");
    EXPECT_EQ(values(block("R_TRIG", "CLK := a"), "k.Q", {{0, 0}, {1, 0}, {1, 0}, {0, 0}, {1, 0}}), "0 1 0 0 1");
    EXPECT_EQ(values(block("F_TRIG", "CLK := a"), "k.Q", {{1, 0}, {0, 0}, {0, 0}, {1, 0}, {0, 0}}), "0 1 0 0 1");
}

TEST(Program, CountersCountEdges) {
    EXPECT_EQ(
        values(block("CTU", "CU := a, R := b, PV := 2"), "k.CV", {{1, 0}, {1, 0}, {0, 0}, {1, 0}, {0, 1}, {1, 1}}),
        "1 1 1 2 0 0");
    EXPECT_EQ(values(block("CTU", "CU := a, R := b, PV := 2"), "k.Q", {{1, 0}, {1, 0}, {0, 0}, {1, 0}, {0, 1}}),
              "0 0 0 1 0");
    EXPECT_EQ(
        values(block("CTD", "CD := a, LD := b, PV := 2"), "k.CV", {{0, 1}, {1, 0}, {0, 0}, {1, 0}, {0, 0}, {1, 0}}),
        "2 1 1 0 0 -1");
    EXPECT_EQ(
        values(block("CTUD", "CU := a, CD := b, PV := 1"), "k.CV", {{1, 0}, {0, 1}, {0, 0}, {1, 1}, {0, 0}, {1, 0}}),
        "1 0 0 0 0 1");
}

TEST(Program, TimersFollowTheTimingDiagrams) {
    const std::vector<std::vector<std::int64_t>> held = {{1, 0}, {1, 0}, {1, 0}, {1, 0},
                                                         {0, 0}, {0, 0}, {0, 0}, {0, 0}};
    EXPECT_EQ(values(block("TON", "IN := a, PT := T#20ms"), "k.Q", held), "0 0 1 1 0 0 0 0");
    EXPECT_EQ(values(block("TON", "IN := a, PT := T#20ms"), "k.ET", held), "0 10 20 20 0 0 0 0");
    EXPECT_EQ(values(block("TON", "IN := a, PT := T#0ms"), "k.Q", held), "1 1 1 1 0 0 0 0");
    EXPECT_EQ(values(block("TOF", "IN := a, PT := T#20ms"), "k.Q", held), "1 1 1 1 1 1 0 0");
    EXPECT_EQ(values(block("TOF", "IN := a, PT := T#20ms"), "k.ET", held), "0 0 0 0 0 10 20 20");
    const std::vector<std::vector<std::int64_t>> pulse = {{1, 0}, {0, 0}, {1, 0}, {1, 0}, {1, 0}, {0, 0}, {1, 0}};
    EXPECT_EQ(values(block("TP", "IN := a, PT := T#30ms"), "k.Q", pulse), "1 1 1 0 0 0 1");
    EXPECT_EQ(values(block("TP", "IN := a, PT := T#30ms"), "k.ET", pulse), "0 10 20 30 30 0 0");
}

TEST(Program, TimeOfATimerRunsOnWhileItIsNotCalled) {
    EXPECT_EQ(values("PROGRAM p VAR_INPUT a, b : BOOL; END_VAR VAR k : TON; END_VAR\n"
                     "IF b THEN k(IN := a, PT := T#30ms); END_IF\nEND_PROGRAM",
                     "k.Q", {{1, 1}, {1, 0}, {1, 0}, {1, 0}, {1, 1}}),
              "0 0 0 0 1");
}

TEST(Program, IntegersWrapAroundAndLaterAssignmentsWin) {
    EXPECT_EQ(
        values("PROGRAM p VAR n : SINT := 126; m : USINT; END_VAR\nn := n + 1; m := m - 1; m := m + 0;\nEND_PROGRAM",
               "n", {{}, {}, {}}),
        "127 -128 -127");
    EXPECT_EQ(
        values("PROGRAM p VAR_INPUT a : BOOL; END_VAR VAR n : INT; END_VAR\nn := 1; IF a THEN RETURN; END_IF; n := 2;\n"
               "END_PROGRAM",
               "n", {{0}, {1}}),
        "2 1");
}

TEST(Program, TimersDoNotDependOnTheSpellingOfOtherNames) {
    const std::vector<std::vector<std::int64_t>> held = {{1}, {1}, {1}, {0}};
    for (const char* const names : {"x, y, z", "Running, y, z", "x, Elapsed, z", "x, y, pt"})
        EXPECT_EQ(values(std::string("PROGRAM p VAR ") + names +
                             " : BOOL; END_VAR VAR_INPUT a : BOOL; END_VAR\n"
                             "VAR k : TON; END_VAR\nk(IN := a, PT := T#20ms);\nEND_PROGRAM\n",
                         "k.ET", held),
                  "0 10 20 0")
            << names;
}

TEST(Program, CaseFindsTheFirstLabelAndLoopsEnd) {
    EXPECT_EQ(values("PROGRAM p VAR_INPUT e : INT; END_VAR VAR n, i : INT; END_VAR\n"
                     "CASE e OF 1..3: n := 1; 2: n := 2; ELSE n := 3; END_CASE\nEND_PROGRAM",
                     "n", {{2}, {4}, {1}}),
              "1 3 1");
    EXPECT_EQ(values("PROGRAM p VAR_INPUT e : INT; END_VAR VAR n, i : INT; END_VAR\nn := 0;\n"
                     "FOR i := 1 TO 10 DO IF i > e THEN EXIT; END_IF; n := n + i; END_FOR\nEND_PROGRAM",
                     "n", {{2}, {4}, {20}}),
              "3 10 55");
}

TEST(Program, InstancesKeepTheirValuesAndFunctionsDoNot) {
    const std::string text =
        "FUNCTION twice : INT VAR_INPUT v : INT; END_VAR VAR s : INT; END_VAR s := s + v; twice := s + v; "
        "END_FUNCTION\n"
        "FUNCTION_BLOCK acc VAR_INPUT v : INT; END_VAR VAR_OUTPUT sum : INT; END_VAR sum := sum + v; "
        "END_FUNCTION_BLOCK\n"
        "PROGRAM p VAR a, b : acc; n : INT; END_VAR\na(v := 1); b(v := twice(5)); a(v := 2); n := a.sum + "
        "b.SUM;\nEND_PROGRAM";
    EXPECT_EQ(values(text, "n", {{}, {}}), "13 26");
}

TEST(Program, ReportsAllErrorsOfAFile) {
    const ReadProgram reading(
        "FUNCTION_BLOCK f VAR g : f; END_VAR END_FUNCTION_BLOCK\n"
        "FUNCTION h : INT h := h() + k(); END_FUNCTION\n"
        "FUNCTION k : INT k := h(); END_FUNCTION\n"
        "PROGRAM p VAR a : BOOL; A : INT; r : REAL; n : INT; END_VAR\n"
        "n := a;\n"
        "n := 40000;\n"
        "q := 1;\n"
        "EXIT;\n"
        "n := 1 / 0;\n"
        "n := a + 1;\n"
        "IF n THEN ; END_IF\n"
        "END_PROGRAM\n");
    EXPECT_EQ(reading.codes(),
              "1:26 recursive-unit\n4:25 duplicate-name\n5:1 type-mismatch\n6:1 out-of-range\n"
              "7:1 unknown-variable\n8:1 not-in-program\n9:6 division-by-zero\n10:6 type-mismatch\n11:4 type-mismatch\n"
              "2:10 recursive-unit\n");
}

TEST(Program, RejectsWhatItDoesNotExecuteExactly) {
    const auto rejected = [](const std::string& body, const std::string& variables = "") {
        return ReadProgram("PROGRAM p VAR x : BOOL; n : INT; d : UDINT; w : WORD; t : TIME; END_VAR " + variables +
                           "\n" + body + "\nEND_PROGRAM")
            .codes();
    };
    EXPECT_EQ(rejected("n := n AND n;"), "2:6 not-in-program\n2:12 not-in-program\n");
    EXPECT_EQ(rejected("w := SHL(w, n);"), "2:6 not-in-program\n");
    EXPECT_EQ(rejected("t := t * t;"), "2:6 type-mismatch\n");
    EXPECT_EQ(rejected("d := d * d;"), "2:6 not-in-program\n");
    EXPECT_EQ(rejected("r := 1;", "VAR r : REAL; END_VAR"), "2:1 not-in-program\n");
    EXPECT_EQ(rejected("WHILE x DO n := n + 1; END_WHILE"), "2:1 unbounded-loop\n");
    EXPECT_EQ(rejected("WHILE TRUE DO n := n + 1; END_WHILE"), "2:1 unbounded-loop\n");
    EXPECT_EQ(rejected("", "VAR_IN_OUT z : INT; END_VAR"), "1:84 not-in-program\n");
    EXPECT_EQ(rejected("", "VAR a AT %IW1 : INT; b AT %IX2.0 : BOOL; END_VAR"), "1:94 not-in-program\n");
}

TEST(Program, SequencesOfBranchesHaveTermsOfLinearSize) {
    std::string body;
    for (int i = 0; i < 2000; ++i) body += "IF x THEN n := n + 1; ELSE n := n - 1; END_IF;\n";
    ReadProgram reading("PROGRAM p VAR_INPUT x : BOOL; END_VAR VAR n : INT; END_VAR\n" + body + "END_PROGRAM");
    ASSERT_TRUE(reading.text);
    std::string small;
    for (int i = 0; i < 300; ++i) small += "IF x THEN n := n + 1; ELSE n := n - 1; END_IF;\n";
    ReadProgram smaller("PROGRAM p VAR_INPUT x : BOOL; END_VAR VAR n : INT; END_VAR\n" + small + "END_PROGRAM");
    Diagnostics diagnostics;
    const auto scan = scan_of(smaller.text->program(), diagnostics);
    ASSERT_TRUE(scan);
    EXPECT_LT(scan->equations.exprs.size(), 300U * 20);
}

}  // namespace
}  // namespace grafverif
