// SPDX-License-Identifier: MIT
// Tests the analysis of PLC programs: each finding, its position, and what must not be reported.
#include "read/program/program.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "pipeline/program/analyse.hpp"

namespace grafverif {
namespace {

Analysis analysis_of(const std::string& program, const Limits& limits = {}) {
    Sources sources;
    Diagnostics diagnostics;
    const auto text = read_program(sources.add({"p.st", program}), sources, diagnostics);
    std::ostringstream errors;
    render_text(diagnostics.all(), sources, Colour::Plain, errors);
    EXPECT_TRUE(text) << errors.str();
    if (!text) return {};
    const auto analysis = analyse_program(text->program(), "p", limits, diagnostics);
    EXPECT_TRUE(analysis);
    if (!analysis) return {};
    EXPECT_EQ(verify(*analysis), std::vector<std::string>());
    EXPECT_EQ(analysis->failures, std::vector<std::string>());
    return *analysis;
}

/// Returns, for each finding, its code and the text at its position up to a semicolon or line end.
std::multiset<std::string> findings(const std::string& program) {
    std::multiset<std::string> found;
    for (const Finding& finding : analysis_of(program).findings) {
        const std::string text = program.substr(finding.origin.begin, finding.origin.end - finding.origin.begin);
        found.insert(finding.code + ": " + text.substr(0, text.find_first_of(";\n")));
    }
    return found;
}

using Findings = std::multiset<std::string>;

std::string program(const std::string& variables, const std::string& body, const std::string& before = "") {
    return before + "PROGRAM p\nVAR_INPUT a, b : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nVAR " + variables +
           " END_VAR\n" + body + "\nEND_PROGRAM\n";
}

TEST(AnalyseProgram, ReportsNothingAboutAProgramWithoutDefects) {
    EXPECT_EQ(findings(program("t : TON; n : INT;", R"(
t(IN := a, PT := T#1s);
IF t.Q THEN n := n + 1; ELSIF b THEN n := 0; ELSE n := n; END_IF
q := FALSE;
IF n > 3 THEN q := TRUE; END_IF
)")),
              Findings());
}

TEST(AnalyseProgram, ReportsConditionsThatReachableStatesDecide) {
    EXPECT_EQ(findings(program("run : BOOL; n : INT;", R"(
run := (a OR run) AND NOT b;
IF run AND b THEN q := TRUE; END_IF
n := n + 1;
IF n > 3 THEN n := 0; END_IF
IF n > 5 THEN q := TRUE; ELSIF n < 4 THEN q := run; ELSE q := a; END_IF
WHILE n > 7 DO n := 0; EXIT; END_WHILE
)")),
              Findings({"condition-never-true: run AND b", "condition-never-true: n > 5",
                        "condition-always-true: n < 4", "condition-never-true: n > 7"}));
}

TEST(AnalyseProgram, DoesNotReportConstantsAsConditions) {
    EXPECT_EQ(findings(program("n : INT;", "IF FALSE THEN q := a; END_IF\nIF TRUE THEN n := 1; ELSE q := b; END_IF")),
              Findings());
}

TEST(AnalyseProgram, ReportsStatementsAfterReturnAndUnusedBranchesOfCase) {
    EXPECT_EQ(findings(program("n : INT (0..2);", R"(
CASE n OF
    0: n := 1;
    1, 2: n := 0;
    3..7: q := a;
ELSE q := b;
END_CASE
RETURN;
q := a;
q := b;
)")),
              Findings({"statement-never-executed: q := a", "statement-never-executed: q := b",
                        "statement-never-executed: q := a"}));
}

TEST(AnalyseProgram, MergesTheInstancesOfABlock) {
    const std::string block =
        "FUNCTION_BLOCK B VAR_INPUT x, y : BOOL; END_VAR VAR_OUTPUT z : BOOL; END_VAR\n"
        "IF x THEN z := TRUE; END_IF\nIF y THEN z := FALSE; END_IF\nEND_FUNCTION_BLOCK\n";
    EXPECT_EQ(
        findings(program("first, second : B;",
                         "first(x := a, y := FALSE);\nsecond(x := FALSE, y := b);\nq := first.z AND second.z;", block)),
        Findings())
        << "each condition is true in one instance";
    EXPECT_EQ(findings(program("first, second : B;", "first(x := a, y := FALSE);\nsecond(x := b, y := FALSE);", block)),
              Findings({"condition-never-true: y"}));
}

TEST(AnalyseProgram, ReportsBlocksFunctionsAndActionsThatAreNeverCalled) {
    EXPECT_EQ(
        findings(program("used, idle : B; late : TON;", "used(x := a);\nIF a AND NOT a THEN late(IN := b); END_IF",
                         "FUNCTION F : INT VAR_INPUT n : INT; END_VAR\nF := n;\nEND_FUNCTION\n"
                         "FUNCTION_BLOCK B VAR_INPUT x : BOOL; END_VAR VAR t : TON; END_VAR\n"
                         "t(IN := x, PT := T#1s);\nEND_FUNCTION_BLOCK\n")),
        Findings({"block-never-called: F", "block-never-called: idle", "block-never-called: late",
                  "condition-never-true: a AND NOT a"}));
}

TEST(AnalyseProgram, ReportsTimersThatNeverElapse) {
    EXPECT_EQ(findings(program("t, u : TON;",
                               "t(IN := a AND NOT t.Q AND q, PT := T#1s);\nu(IN := a, PT := T#1s);\nq := t.Q;")),
              Findings({"timer-never-true: t"}));
    EXPECT_EQ(findings(program("t : TON; x : BOOL;", "t(IN := a, PT := T#0s);\nx := t.Q;\nt(IN := FALSE);\nq := x;")),
              Findings())
        << "the output is true only during the scan";
}

TEST(AnalyseProgram, ReportsAssignmentsThatAreAlwaysReplaced) {
    const Analysis analysis = analysis_of(program("", "q := a;\nIF b THEN q := TRUE; ELSE q := FALSE; END_IF"));
    ASSERT_EQ(analysis.findings.size(), 1U);
    EXPECT_EQ(analysis.findings.front().code, "assignment-overwritten");
    EXPECT_EQ(analysis.findings.front().subject, "q");
    EXPECT_EQ(analysis.findings.front().related.size(), 2U);
    EXPECT_EQ(findings(program("", "q := a;\nIF b THEN q := TRUE; END_IF")), Findings()) << "a default value";
    EXPECT_EQ(findings(program("i : INT;", "FOR i := 1 TO 3 DO q := a; END_FOR")), Findings()) << "the same statement";
}

TEST(AnalyseProgram, ReportsStepsAndTransitionsThatAreNeverUsed) {
    EXPECT_EQ(findings("PROGRAM p VAR_INPUT a : BOOL; END_VAR VAR_OUTPUT q : BOOL; END_VAR\n"
                       "INITIAL_STEP One: END_STEP\nSTEP Two: q(N); END_STEP\nSTEP Three: END_STEP\n"
                       "TRANSITION FROM One TO Two := a; END_TRANSITION\n"
                       "TRANSITION FROM Two TO One := NOT q; END_TRANSITION\n"
                       "TRANSITION FROM Two TO Three := a AND Two.T < T#0s; END_TRANSITION\n"
                       "TRANSITION FROM Three TO One := a; END_TRANSITION\nEND_PROGRAM\n"),
              Findings({"step-never-active: Three", "transition-never-fired: NOT q",
                        "transition-never-fired: a AND Two.T < T#0s"}));
}

TEST(AnalyseProgram, ReportsARunTimeFaultWithItsTrace) {
    const Analysis analysis = analysis_of(
        program("n : INT := 2;", "IF a THEN n := n - 1; END_IF\nq := 4 / n > 1;\nIF n < 0 THEN q := b; END_IF"));
    ASSERT_EQ(analysis.findings.size(), 2U);
    EXPECT_EQ(analysis.findings.front().code, "no-value");
    ASSERT_TRUE(analysis.findings.front().evidence);
    EXPECT_FALSE(analysis.findings.front().evidence->rows.empty());
    EXPECT_EQ(analysis.findings.back().code, "condition-never-true") << "n is negative only after the fault";
}

TEST(AnalyseProgram, ListsUndecidedQueriesIfALimitIsReached) {
    std::atomic<bool> stop = true;
    Limits limits;
    limits.stop = &stop;
    const Analysis analysis = analysis_of(program("n : INT;", "n := n + 1;\nIF n = 30000 THEN q := a; END_IF"), limits);
    EXPECT_FALSE(analysis.open.empty());
    EXPECT_NE(analysis.obstacle, "");
    EXPECT_EQ(analysis.findings.size(), 0U) << "what is not proved is not reported";
}

}  // namespace
}  // namespace grafverif
