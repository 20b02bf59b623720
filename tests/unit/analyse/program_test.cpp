// SPDX-License-Identifier: MIT
// Tests the analysis of PLC programs: each finding, its position, and what must not be reported.
#include "read/program/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
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
              Findings({"condition-never-true: y", "variable-never-assigned: q"}));
}

TEST(AnalyseProgram, ReportsBlocksFunctionsAndActionsThatAreNeverCalled) {
    EXPECT_EQ(
        findings(program("used, idle : B; late : TON;", "used(x := a);\nIF a AND NOT a THEN late(IN := b); END_IF",
                         "FUNCTION F : INT VAR_INPUT n : INT; END_VAR\nF := n;\nEND_FUNCTION\n"
                         "FUNCTION_BLOCK B VAR_INPUT x : BOOL; END_VAR VAR t : TON; END_VAR\n"
                         "t(IN := x, PT := T#1s);\nEND_FUNCTION_BLOCK\n")),
        Findings({"block-never-called: F", "block-never-called: idle", "block-never-called: late",
                  "condition-never-true: a AND NOT a", "variable-never-assigned: q"}));
}

TEST(AnalyseProgram, ReportsTimersThatNeverElapse) {
    EXPECT_EQ(findings(program("t, u : TON;",
                               "t(IN := a AND NOT t.Q AND q, PT := T#1s);\nu(IN := a, PT := T#1s);\nq := t.Q;")),
              Findings({"timer-never-true: t"}));
    EXPECT_EQ(findings(program("t : TON; x : BOOL;", "t(IN := a, PT := T#0s);\nx := t.Q;\nt(IN := FALSE);\nq := x;")),
              Findings())
        << "the output is true only during the scan";
}

TEST(AnalyseProgram, ReportsVariablesThatNoStatementAssigns) {
    EXPECT_EQ(findings(program("x, y : INT; set : INT := 3; unread : INT; v : ARRAY[1..3] OF INT;",
                               "q := x > set AND v[2] = 0 AND y > 0;\ny := y + 1;")),
              Findings({"variable-never-assigned: v", "variable-never-assigned: x"}));
    EXPECT_EQ(findings(program("v : ARRAY[0..3] OF INT; i : INT;", "q := v[1] = i;\nv[i] := 1;\ni := 2;")), Findings())
        << "an index that is not constant can denote each element";
    EXPECT_EQ(findings(program("t : B;", "t(x := a);\nq := t.z;",
                               "FUNCTION_BLOCK B VAR_INPUT x, y : BOOL; END_VAR VAR_OUTPUT z : BOOL; END_VAR\n"
                               "VAR w : BOOL; END_VAR\nz := x OR w OR y;\nEND_FUNCTION_BLOCK\n")),
              Findings({"variable-never-assigned: w"}))
        << "calls may omit inputs";
    EXPECT_EQ(findings("PROGRAM p VAR_INPUT a : BOOL; END_VAR VAR_OUTPUT q, r : BOOL; END_VAR\nq := a;\nEND_PROGRAM\n"),
              Findings({"variable-never-assigned: r"}));
}

TEST(AnalyseProgram, ReportsReadsBeforeTheAssignmentInTheSameCall) {
    const std::string before =
        "FUNCTION Twice : INT VAR_INPUT n : INT; END_VAR VAR sum : INT; END_VAR\n"
        "sum := sum + n;\nTwice := 2 * sum;\nEND_FUNCTION\n";
    EXPECT_EQ(findings(program("n : INT; END_VAR VAR_TEMP t, u, w : INT; i : INT;", R"(
IF a THEN t := 1; END_IF
n := t;
q := u > 0;
u := Twice(n);
FOR i := 1 TO 3 DO w := w + i; END_FOR
)",
                               before)),
              Findings({"read-before-assignment: sum", "read-before-assignment: u"}))
        << "an earlier iteration assigns `w`";
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

TEST(AnalyseProgram, DoesNotReportAssignmentsThatAreReadBeforeTheyAreReplaced) {
    EXPECT_EQ(findings(program("x : BOOL;", "q := a;\nx := q;\nq := b;")), Findings());
    EXPECT_EQ(findings(program("x : BOOL;", "q := a;\nq := b;\nx := q;")),
              Findings({"assignment-overwritten: q := a"}));
    EXPECT_EQ(findings(program("x : BOOL;", "q := a;\nIF b THEN x := q; END_IF\nq := b;")), Findings());
    EXPECT_EQ(findings(program("x : BOOL;", "q := a;\nIF a AND NOT a THEN x := q; END_IF\nq := b;")),
              Findings({"assignment-overwritten: q := a", "condition-never-true: a AND NOT a"}));
    EXPECT_EQ(findings(program("x : BOOL;", "q := a;\nIF q THEN x := a; END_IF\nq := b;")), Findings())
        << "a condition";
    const std::string counts =
        "PROGRAM p VAR_INPUT n : SINT; END_VAR VAR_OUTPUT w : INT; END_VAR VAR hi : BOOL; END_VAR\n";
    EXPECT_EQ(findings(counts + "w := n;\nhi := w > 100;\nw := w + 1;\nEND_PROGRAM"), Findings());
    EXPECT_EQ(findings(counts + "w := n;\nFOR w := 1 TO 3 DO hi := w > n; w := w + 1; END_FOR\nw := 0;\nEND_PROGRAM"),
              Findings())
        << "the loop reads its variable";
}

/// A line of a program that accesses an output if the inputs have the values of `guard` (0: any value).
struct AccessLine {
    bool reads = false;
    std::size_t output = 0;
    std::array<int, 3> guard = {};
    bool executed(unsigned inputs) const {
        for (std::size_t k = 0; k < guard.size(); ++k)
            if (guard[k] != 0 && (guard[k] == 1) != ((inputs >> k & 1U) != 0)) return false;
        return true;
    }
};

/// True if the line assigns a value that, for all inputs, another line replaces before a line reads it.
bool is_replaced(const std::vector<AccessLine>& lines, std::size_t at) {
    bool executed = false;
    for (unsigned inputs = 0; inputs < 8; ++inputs) {
        if (lines[at].reads || !lines[at].executed(inputs)) continue;
        executed = true;
        const auto next = std::find_if(
            lines.begin() + static_cast<std::ptrdiff_t>(at) + 1, lines.end(),
            [&](const AccessLine& line) { return line.output == lines[at].output && line.executed(inputs); });
        if (next == lines.end() || next->reads) return false;
    }
    return executed;
}

TEST(AnalyseProgram, ReplacedAssignmentsOfRandomProgramsAgreeWithAnEnumeration) {
    std::mt19937 random(1);
    std::size_t reported = 0;
    for (int round = 0; round < 60; ++round) {
        std::string text =
            "PROGRAM p VAR_INPUT a, b, c : BOOL; END_VAR VAR_OUTPUT q, r : BOOL; END_VAR VAR x : BOOL; END_VAR\n";
        std::vector<AccessLine> lines(8);
        for (AccessLine& line : lines) {
            line.reads = random() % 4 == 0;
            line.output = random() % 2;
            std::string condition;
            for (std::size_t k = 0; k < line.guard.size(); ++k) {
                line.guard[k] = random() % 2 == 0 ? 0 : 1 + static_cast<int>(random() % 2);
                if (line.guard[k] == 0) continue;
                condition +=
                    (condition.empty() ? "" : " AND ") + std::string(line.guard[k] == 1 ? "" : "NOT ") + "abc"[k];
            }
            const std::string output(1, "qr"[line.output]);
            text += "IF " + (condition.empty() ? "TRUE" : condition) + " THEN " +
                    (line.reads ? "x := " + output : output + " := NOT a") + "; END_IF\n";
        }
        text += "END_PROGRAM\n";
        std::set<std::size_t> found, expected;
        for (const Finding& finding : analysis_of(text).findings)
            if (finding.code == "assignment-overwritten")
                found.insert(static_cast<std::size_t>(
                    std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(finding.origin.begin), '\n') -
                    1));
        for (std::size_t k = 0; k < lines.size(); ++k)
            if (is_replaced(lines, k)) expected.insert(k);
        EXPECT_EQ(found, expected) << text;
        reported += found.size();
    }
    EXPECT_GT(reported, 20U);
}

TEST(AnalyseProgram, DoesNotReportAssignmentsThatABlockReadsAsInOut) {
    const std::string block =
        "FUNCTION_BLOCK B VAR_INPUT c : BOOL; END_VAR VAR_IN_OUT v : BOOL; END_VAR\n"
        "IF c THEN v := TRUE; END_IF\nEND_FUNCTION_BLOCK\n";
    EXPECT_EQ(findings(program("f : B;", "q := FALSE;\nf(c := a, v := q);", block)), Findings());
}

TEST(AnalyseProgram, MergesTheCellsAndExecutionsOfAnAssignment) {
    const auto outputs = [](const std::string& declared, const std::string& body, const std::string& before = "") {
        return before + "PROGRAM p\nVAR_INPUT a, b : BOOL; END_VAR\nVAR_OUTPUT " + declared +
               " END_VAR\nVAR i : INT; END_VAR\n" + body + "\nEND_PROGRAM\n";
    };
    const std::string array = "o : ARRAY[0..3] OF BOOL;";
    EXPECT_EQ(findings(outputs(array, "i := (i + 1) MOD 4;\no[i] := a;\no[3] := b;")), Findings());
    EXPECT_EQ(findings(outputs(array, "o[2] := a;\no[2] := b;")), Findings({"assignment-overwritten: o[2] := a"}));
    const std::string structure = "TYPE S : STRUCT x, y : BOOL; END_STRUCT; END_TYPE\n";
    EXPECT_EQ(findings(outputs("o, d : S;", "o := d;\no.x := a;", structure)), Findings());
    EXPECT_EQ(findings(outputs("o, d : S;", "o := d;\no.x := a;\no.y := b;", structure)),
              Findings({"assignment-overwritten: o := d"}));
    const auto instances = [](const std::string& on) {
        return program("first, second : B;", "first(x := a, on := TRUE);\nsecond(x := b, on := " + on + ");",
                       "FUNCTION_BLOCK B VAR_INPUT x, on : BOOL; END_VAR VAR z AT %Q* : BOOL; END_VAR\n"
                       "z := x;\nIF on THEN z := FALSE; END_IF\nEND_FUNCTION_BLOCK\n");
    };
    EXPECT_EQ(findings(instances("a")), Findings({"variable-never-assigned: q"}));
    EXPECT_EQ(findings(instances("TRUE")),
              Findings({"assignment-overwritten: z := x", "condition-always-true: on", "variable-never-assigned: q"}));
}

TEST(AnalyseProgram, ConsidersTheScanWithARunTimeFault) {
    const auto codes = [](const std::string& body) {
        std::multiset<std::string> found;
        for (const Finding& finding : analysis_of(program("n : INT; z : INT := 0;", body)).findings)
            found.insert(finding.code);
        return found;
    };
    EXPECT_EQ(codes("IF a THEN q := TRUE; n := 10 / z; END_IF"), Findings({"no-value"}));
    EXPECT_EQ(codes("q := a;\nIF a THEN n := 10 / z; END_IF\nq := b;"), Findings({"no-value"}))
        << "the output keeps its value after the fault";
}

TEST(AnalyseProgram, DoesNotReportTimersOfActions) {
    EXPECT_EQ(findings("PROGRAM p VAR_INPUT a : BOOL; END_VAR VAR_OUTPUT q : BOOL; END_VAR\n"
                       "INITIAL_STEP One: END_STEP\nSTEP Two: Act(L, T#1s); END_STEP\n"
                       "TRANSITION FROM One TO Two := a; END_TRANSITION\n"
                       "TRANSITION FROM Two TO One := TRUE; END_TRANSITION\n"
                       "ACTION Act: q := NOT q; END_ACTION\nEND_PROGRAM\n"),
              Findings());
}

TEST(AnalyseProgram, DoesNotReportConfigurationsByConstants) {
    EXPECT_EQ(findings(program("n : INT; END_VAR VAR CONSTANT Mode : INT := 1; On : BOOL := TRUE;", R"(
IF Mode = 2 THEN n := 1; ELSIF NOT On THEN n := 2; ELSIF a THEN n := 3; END_IF
IF Mode = 1 THEN n := 4; ELSE n := 5; END_IF
CASE Mode OF
    1: q := a;
    2: q := b;
END_CASE
)")),
              Findings());
}

TEST(AnalyseProgram, NamesProgramsAndReportsUnusedBlocksOnce) {
    const std::string text =
        "FUNCTION_BLOCK B VAR_INPUT x : BOOL; END_VAR VAR n : BOOL; END_VAR\nn := x;\n"
        "ACTION Act: n := FALSE; END_ACTION\nEND_FUNCTION_BLOCK\n"
        "PROGRAM other VAR b : B; x : BOOL; END_VAR\nx := TRUE;\nb(x := x);\nEND_PROGRAM\n" +
        program("", "q := a;") +
        "CONFIGURATION c\nTASK t(INTERVAL := T#10ms, PRIORITY := 1);\nPROGRAM i WITH t : p;\nEND_CONFIGURATION\n";
    EXPECT_EQ(findings(text), Findings({"block-never-called: B", "block-never-called: other"}));
    std::multiset<std::string> found;
    for (const Finding& finding : analysis_of(text).findings) found.insert(finding.message);
    EXPECT_EQ(found, Findings({"the function block `B` is never called", "the program `other` is never executed"}));
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

TEST(AnalyseProgram, ListsAnUndecidedRunTimeFault) {
    std::atomic<bool> stop = true;
    Limits limits;
    limits.stop = &stop;
    const Analysis analysis = analysis_of(program("n : INT := 2;", "n := n + 1;\nq := 4 / n > 1;"), limits);
    EXPECT_EQ(std::ranges::count(analysis.open, "no-value", &OpenQuestion::code), 1);
    EXPECT_NE(analysis.obstacle, "");
}

}  // namespace
}  // namespace grafverif
