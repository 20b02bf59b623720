// SPDX-License-Identifier: MIT
// Tests `plc`: the line protocol of docs/how-to/test-a-plc.md controls the chart.
#include <gtest/gtest.h>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

const std::string tanks = (root / "samples/tanks/tanks.grafcet").string();

/// Writes the chart to a separate file and executes it with `lines`.
Result played(const std::string& declarations, const std::string& lines, std::vector<std::string> options = {}) {
    const Folder folder;
    options.insert(options.begin(), {"plc", folder.write("c.grafcet", "grafcet c {\n" + declarations + "\n}\n")});
    return grafverif(options, lines);
}

constexpr const char* pulse =
    "input go; output L; initial step 0; step 1 { L; }\n"
    "transition a: 0 -> 1 when go; transition b: 1 -> 0 when 3s/X1;";

TEST(Plc, RespondsToEachLineOfInputsWithOutputs) {
    const Result result = grafverif({"plc", tanks}, "0,0,0,1,1\n1,1,0,1,1\n0 0 1 1 1\n");
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    EXPECT_EQ(result.out, "0,0,0,0\n0,1,1,0\n0,0,1,1\n");
}

TEST(Plc, WritesOutputsInEveryCycleWithoutStabilitySearch) {
    const std::vector<std::string> arguments = {"plc", tanks, "--mode", "every-cycle"};
    EXPECT_EQ(grafverif(arguments, "0,0,0,1,1\n1,1,0,1,1\n1,1,0,1,1\n").out, "0,0,0,0\n1,1,0,0\n0,1,1,0\n");
}

TEST(Plc, RunsInTheModeOfTheLoopsInTheFile) {
    const Folder folder;
    const std::string file =
        folder.write("c.grafcet",
                     "grafcet c { input a; output L; initial step 0; step 1 { L; } step 2;\n"
                     "transition t: 0 -> 1 when a; transition u: 1 -> 2 when a; transition v: 2 -> 0 when !a; }\n"
                     "closed_loop l { controller c with every_cycle; environment A = push_button(OUT = a); }\n");
    EXPECT_EQ(grafverif({"plc", file}, "0\n1\n").out, "0\n1\n");
    EXPECT_EQ(grafverif({"plc", file, "--mode", "stability-search"}, "0\n1\n").out, "0\n0\n");
}

TEST(Plc, LetsTimePassByWaitLines) { EXPECT_EQ(played(pulse, "1\nwait 2999 ms\n0\nwait 1ms\n0\n").out, "1\n1\n0\n"); }

TEST(Plc, CountsTimeFromItsFirstScan) {
    const std::string timed = "output L; initial step 0; step 1 { L; } transition a: 0 -> 1 when 3s/X0;";
    EXPECT_EQ(played(timed, "wait 3s\n\nwait 3s\n\n").out, "0\n1\n");
}

TEST(Plc, LetsRealTimePass) {
    const std::string quick =
        "output L; initial step 0; step 1 { L; }\n"
        "transition a: 0 -> 1 when 1ms/X0;";
    std::string lines;
    for (int k = 0; k < 200'000; ++k) lines += "\n";
    const std::string out = played(quick, lines, {"--clock", "real"}).out;
    EXPECT_TRUE(out.starts_with("0\n"));
    EXPECT_TRUE(out.ends_with("1\n"));
    EXPECT_EQ(played(pulse, "wait 3s\n", {"--clock", "real"}).code, ExitCode::Input);
}

TEST(Plc, AnswersAnInvalidLineAndContinues) {
    struct Case {
        const char* line;
        const char* problem;
    };
    for (const Case& c : {
             Case{"1,1", "more than 1 value, expected 1"},
             Case{"", "0 values, expected 1"},
             Case{"2", "the value `2` of `go` is outside the range 0 to 1"},
             Case{"on", "`on` is not a value of `go`"},
             Case{"\x01\x80", "`??` is not a value of `go`"},
             Case{"99999999999999999999", "`99999999999999999999` is not a value of `go`"},
             Case{"wait", "`wait` requires a duration"},
             Case{"wait -3s", "`wait` requires a duration"},
             Case{"waiting", "`wait` requires a duration"},
         }) {
        SCOPED_TRACE(c.line);
        const Result result = played(pulse, std::string(c.line) + "\n1\n");
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_TRUE(result.out.starts_with("error: " + std::string(c.problem))) << result.out;
        EXPECT_TRUE(result.out.ends_with("\n1\n")) << "the line was executed as a scan, or ended the session";
        EXPECT_NE(result.err.find("line 1: error"), std::string::npos);
    }
}

TEST(Plc, ReadsHugeLinesWithoutKeepingThem) {
    const Result result = played(pulse, std::string(50'000'000, '1') + "\n1\n");
    EXPECT_EQ(result.out,
              "error: the line is longer than 4096 bytes; shorten it\n"
              "1\n");
}

TEST(Plc, AcceptsIntegersWithinTheirRange) {
    const std::string level = "input l: int -2..5; output H; initial step 0 { H if l > 3; }";
    EXPECT_EQ(played(level, "3\n5\n-2\ntrue\n").out, "0\n1\n0\n0\n");
    EXPECT_EQ(played(level, "6\n").out, "error: the value `6` of `l` is outside the range -2 to 5\n");
}

TEST(Plc, StopsWithAReasonIfTheChartCannotContinue) {
    struct Case {
        const char* chart;
        const char* reason;
    };
    for (const Case& c : {
             Case{"input a; output L; initial step 0; step 1 { L; }\n"
                  "transition t: 0 -> 1 when a; transition u: 1 -> 0 when a;",
                  "with these inputs, the situation never becomes stable: {1} -> {0} -> {1}, forever within one "
                  "instant [total-instability]"},
             Case{"input a; output L; partial G2 { initial step 0; step 1 { L; }\n"
                  "transition t: 0 -> 1 when a; transition u: 1 -> 0 when a; }",
                  "with these inputs, the situation never becomes stable: {G2.1} -> {G2.0} -> {G2.1}, forever"},
             Case{"input a; output L; internal N: int 0..3 = 0; initial step 0; step 1 { N := 1 on activation; L; }\n"
                  "step 2 { N := 2 on activation; } transition t: 0 -> 1, 2 when a;",
                  "two stored actions assign different values to `N` in one evolution [action-race]"},
             Case{"input a; output L; internal N: int 0..3 = 0; initial step 0; step 1 { N := N + 4 on activation; L; "
                  "}\n"
                  "transition t: 0 -> 1 when a;",
                  "the value 4 of `N` is outside its range 0..3 [out-of-range]"},
         }) {
        SCOPED_TRACE(c.reason);
        const Result result = played(c.chart, "0\n1\n0\n");
        EXPECT_EQ(result.code, ExitCode::Verdict);
        EXPECT_TRUE(result.out.starts_with("0\nerror: " + std::string(c.reason))) << result.out;
        EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 2) << "the session continued after the error";
    }
}

TEST(Plc, RejectsAChartThatCannotRun) {
    const Result result = played("input a; step 0;", "0\n");
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_EQ(result.out, "");
}

}  // namespace
}  // namespace grafverif::app
