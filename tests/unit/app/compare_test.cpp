// SPDX-License-Identifier: MIT
// Tests `compare` with charts that are equal, different, undecided, and not comparable.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_program.hpp"
#include "unit/read/fixtures.hpp"

namespace grafverif::app {
namespace {

const std::string tanks = (root / "samples/tanks/tanks.grafcet").string();

const std::string lamp =
    "grafcet lamp {\n    input on, off;\n    output L;\n\n    initial step 0;\n    step 1 { L; }\n\n"
    "    transition t0: 0 -> 1 when on;\n    transition t1: 1 -> 0 when off;\n}\n";

Result compared(const std::string& a, const std::string& b, std::vector<std::string> options = {}) {
    const Folder folder;
    options.insert(options.begin(), {"compare", folder.write("a.grafcet", a), folder.write("b.grafcet", b)});
    return grafverif(options);
}

/// Returns `text` with one word replaced.
std::string with(std::string text, const std::string& before, const std::string& after) {
    return text.replace(text.find(before), before.size(), after);
}

TEST(Compare, AChartIsEqualToItselfInEachMode) {
    for (const std::string mode : {"stability-search", "every-cycle"}) {
        const Result result = grafverif({"compare", tanks, tanks, "--mode", mode});
        EXPECT_EQ(result.code, ExitCode::Done) << result.err;
        EXPECT_NE(result.out.find(": equal\n"), std::string::npos) << result.out;
        EXPECT_NE(result.out.find("the texts differ at most in order and layout"), std::string::npos) << result.out;
    }
}

TEST(Compare, OneRunComparesInEachMode) {
    const Result result = grafverif({"compare", tanks, tanks, "--all-modes"});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    const std::size_t first = result.out.find("mode stability-search"), second = result.out.find("mode every-cycle");
    EXPECT_LT(first, second) << result.out;
    EXPECT_EQ(result.out.find("the texts differ"), result.out.rfind("the texts differ")) << "once";
    // An additional transient step is visible only in every_cycle mode.
    const std::string longer = with(with(lamp, "step 1 {", "step 9;\n    step 1 {"), "0 -> 1 when on;",
                                    "0 -> 9 when on && !off;\n    transition t9: 9 -> 1 when true;");
    const std::string plain = with(lamp, "when on;", "when on && !off;");
    const Result apart = compared(plain, longer, {"--all-modes", "--format", "json"});
    EXPECT_EQ(apart.code, ExitCode::Verdict) << apart.err;
    const auto json = nlohmann::json::parse(apart.out, nullptr, false);
    ASSERT_EQ(json.size(), 2U) << apart.out;
    EXPECT_EQ(json[0]["outcome"], "equal");
    EXPECT_EQ(json[1]["outcome"], "different");
    EXPECT_EQ(compared(lamp, lamp, {"--all-modes", "--mode", "every-cycle"}).code, ExitCode::Input);
}

TEST(Compare, ImportedChartIsEqualToItsFile) {
    const Folder folder;
    for (const auto& [name, text] : {std::pair{"agrafe.xml", &fixtures::agrafe},
                                     {"plcopen.xml", &fixtures::plcopen},
                                     {"sfc.st", &fixtures::sfc}}) {
        SCOPED_TRACE(name);
        const std::string file = folder.write(name, *text), taken = folder.file("taken.grafcet");
        ASSERT_EQ(grafverif({"import", file, "--lossy", "-o", taken}).code, ExitCode::Done);
        const Result result =
            grafverif({"compare", file, taken, "--lossy", "--all-modes", "--timeout", "60s", "--imported-charts"});
        EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
        EXPECT_NE(result.out.find("the texts differ at most in order and layout"), std::string::npos) << result.out;
    }
}

TEST(Compare, RejectsAProgramInPlaceOfAnImportedChart) {
    const Folder folder;
    for (const std::string form : {"text", "xml"}) {
        const std::string program = folder.file("program");
        ASSERT_EQ(grafverif({"st", tanks, "--format", form, "-o", program}).code, ExitCode::Done) << form;
        const Result result = grafverif({"compare", tanks, program, "--imported-charts"});
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_NE(result.err.find("`tanks` is a program without a Sequential Function Chart"), std::string::npos)
            << result.err;
        EXPECT_NE(result.err.find("`grafverif check FILE --properties PROPERTIES`"), std::string::npos);
    }
}

TEST(Compare, RenamedStepsAreListedAndDoNotMatter) {
    const std::string other = with(
        with(with(with(lamp, "step 1 {", "step ON {"), "0 -> 1", "0 -> ON"), "t1: 1", "t1: ON"), "on, off", "off, on");
    const Result result = compared(lamp, other);
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    EXPECT_NE(result.out.find("  step 1 renamed: 1\n    now ON\n"), std::string::npos) << result.out;
}

TEST(Compare, IdenticalAndRenamedChartsWithManyTimersAreEqual) {
    const std::string timers =
        "grafcet t {\n    input a, b, c;\n    output o, p, q;\n    initial step 0 { o after 3s; }\n"
        "    step 1 { p after 2s for 3s; }\n    step 2 { q; }\n    transition t0: 0 -> 1 when 3s/(b && c)/2s;\n"
        "    transition t1: 1 -> 2 when fall(b && c);\n    transition t2: 2 -> 0 when a;\n}\n";
    const std::string renamed =
        with(with(with(timers, "step 2 {", "step LAST {"), "1 -> 2", "1 -> LAST"), "t2: 2", "end: LAST");
    for (const std::string& other : {timers, renamed}) {
        const Result result = compared(timers, other, {"--timeout", "20s"});
        EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
        EXPECT_NE(result.out.find(": equal\n"), std::string::npos) << result.out;
    }
    const Result equivalent = compared(timers, with(timers, "when a;", "when a && (b || !b);"), {"--timeout", "60s"});
    EXPECT_EQ(equivalent.code, ExitCode::Done) << equivalent.out << equivalent.err;
    const Result impossible = compared(with(timers, "output o", "constraint a && !a;\n    output o"),
                                       with(timers, "output o", "constraint a && !a;\n    output o"));
    EXPECT_EQ(impossible.code, ExitCode::Unknown);
    EXPECT_NE(impossible.out.find("no inputs satisfy the constraints of both charts"), std::string::npos);
    const Result other_time = compared(timers, with(timers, "3s/(b", "4s/(b"), {"--timeout", "20s"});
    EXPECT_NE(other_time.code, ExitCode::Done) << other_time.out;
}

TEST(Compare, ADifferenceIsTheShortestSequenceWithBothOutputs) {
    const Result result = compared(lamp, with(lamp, "when off", "when off && !on"));
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
    EXPECT_EQ(result.out,
              "`lamp` (a) and `lamp` (b): different\n"
              "  distinguished by 1 scan, replayed under the rules of IEC 60848:\n"
              "  time  inputs   a writes                       b writes\n"
              "  0 s   on, off  stops: with these inputs, the  L  in {1}\n"
              "                 situation never becomes\n"
              "                 stable: {0} -> {1} -> {0},\n"
              "                 forever within one instant\n"
              "                 [total-instability]\n"
              "  in the last scan, only `a` stops\n"
              "  a scan is one PLC cycle, mode stability-search\n"
              "differences between the texts, from a to b:\n"
              "  transition t1 changed: 1 -> 0 when off\n"
              "    now 1 -> 0 when off && !on\n");
}

TEST(Compare, TimesDistinguishCharts) {
    const std::string pulse = with(lamp, "when off", "when 3s/X1");
    const Result same = compared(pulse, pulse);
    EXPECT_EQ(same.code, ExitCode::Done) << same.out << same.err;
    EXPECT_NE(same.out.find("; scans occur at arbitrary multiples of 1500ms\n"), std::string::npos) << same.out;
    const Result other = compared(pulse, with(pulse, "3s", "2s"), {"--format", "json", "--mode", "every-cycle"});
    EXPECT_EQ(other.code, ExitCode::Verdict) << other.err;
    const auto json = nlohmann::json::parse(other.out);
    EXPECT_EQ(json["outcome"], "different");
    EXPECT_EQ(json["shortest"], true);
    EXPECT_EQ(json["resolution_ms"], 500);
    // The scans are power-on, the first transition and the second transition.
    ASSERT_EQ(json["scans"].size(), 3U) << other.out;
    EXPECT_EQ(json["scans"].back()["time_ms"], 2000) << other.out;
    EXPECT_EQ(json["scans"].back()["answers"][0]["outputs"]["L"], true);
    EXPECT_EQ(json["scans"].back()["answers"][1]["outputs"]["L"], false);
    EXPECT_EQ(json["changes"][0]["subject"], "transition t1");
}

TEST(Compare, TwoSequentialTimesDifferFromTheirSumIfAScanIsLate) {
    const std::string once = with(lamp, "when off", "when 2s/X1");
    const std::string twice = with(with(once, "step 1 { L; }", "step 1 { L; }\n    step 2 { L; }"),
                                   "1 -> 0 when 2s/X1;", "1 -> 2 when 1s/X1;\n    transition t2: 2 -> 0 when 1s/X2;");
    const Result result = compared(once, twice);
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
    EXPECT_NE(result.out.find("  step 2 added: step 2 { L; }\n"), std::string::npos) << result.out;
}

TEST(Compare, AResolutionDividesEveryDuration) {
    const std::string pulse = with(lamp, "when off", "when 3s/X1");
    EXPECT_EQ(compared(pulse, pulse, {"--resolution", "1s"}).code, ExitCode::Done);
    const Result coarse = compared(pulse, pulse, {"--resolution", "2s"});
    EXPECT_EQ(coarse.code, ExitCode::Input);
    EXPECT_NE(coarse.err.find("`--resolution 2s` does not divide `3s`; use `3s` or a divisor of it [not-comparable]"),
              std::string::npos)
        << coarse.err;
    EXPECT_EQ(compared(pulse, pulse, {"--resolution", "0s"}).code, ExitCode::Input);
}

TEST(Compare, AResolutionBeyondEveryClockIsTooCoarse) {
    const std::string timed = with(lamp, "when off", "when 2s/X1");
    for (const char* time : {"106751991167h", "2562047788016h", "18446744073709551615ms"}) {
        const Result result = compared(timed, timed, {"--resolution", time});
        EXPECT_EQ(result.code, ExitCode::Input) << time << result.out;
        EXPECT_NE(result.err.find("[not-comparable]"), std::string::npos) << result.err;
    }
    EXPECT_EQ(compared(timed, timed, {"--resolution", "99999999999999999999h"}).code, ExitCode::Input);
}

TEST(Compare, OtherInputsOrOutputsAreNamed) {
    const Result result = compared(lamp, with(with(lamp, "on, off", "on, stop"), "when off", "when stop"));
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_NE(result.err.find("the input `off` exists only in `lamp` (a)"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("the input `stop` exists only in `lamp` (b)"), std::string::npos) << result.err;
    const Result ranges = compared(with(lamp, "on, off;", "on, off; input n: int 0..3;"),
                                   with(lamp, "on, off;", "on, off; input n: int 0..4;"));
    EXPECT_EQ(ranges.code, ExitCode::Input);
    EXPECT_NE(ranges.err.find("the input `n` is an integer from 0 to 3 here and an integer from 0 to 4"),
              std::string::npos)
        << ranges.err;
}

TEST(Compare, ChartsAreComparedFromASituation) {
    const std::string other = with(lamp, "initial step 0;\n    step 1", "step 0;\n    initial step 1");
    EXPECT_EQ(compared(lamp, other).code, ExitCode::Verdict);
    const Result same = compared(lamp, other, {"--from-situation", "0"});
    EXPECT_EQ(same.code, ExitCode::Done) << same.out << same.err;
    EXPECT_NE(same.out.find("  a starts in {0} and b in {0}\n"), std::string::npos) << same.out;
    EXPECT_EQ(compared(lamp, other, {"--from-situation", "0:1"}).code, ExitCode::Verdict);
    const Result none = compared(lamp, other, {"--from-situation", "7"});
    EXPECT_EQ(none.code, ExitCode::Input);
    EXPECT_NE(none.err.find("the file has no step `7`"), std::string::npos) << none.err;
    const std::string enclosed =
        "grafcet g { input a; output L;\n    initial step 0; enclosing step 1 encloses G;\n"
        "    transition t0: 0 -> 1 when a;\n    partial G { linked step 2 { L; } step 3; transition u: 2 -> 3 when !a; "
        "}\n}\n";
    const Result alone = compared(enclosed, enclosed, {"--from-situation", "G.3"});
    EXPECT_EQ(alone.code, ExitCode::Input);
    EXPECT_NE(
        alone.err.find("cannot start in the situation of `--from-situation`: in this situation, `G.X3` is not active"),
        std::string::npos)
        << alone.err;
    EXPECT_EQ(compared(enclosed, enclosed, {"--from-situation", "1,G.3"}).code, ExitCode::Done);
}

TEST(Compare, ConstraintsAreAssumedAndMayNotContradict) {
    const std::string apart = with(lamp, "output L;", "output L;\n    constraint !(on && off);");
    const Result same = compared(apart, with(lamp, "when off", "when off && !on"));
    EXPECT_EQ(same.code, ExitCode::Done) << same.out;
    EXPECT_NE(same.out.find("  the constraints of both charts are assumed\n"), std::string::npos) << same.out;
    const Result none = compared(with(lamp, "output L;", "output L; constraint on;"),
                                 with(lamp, "output L;", "output L; constraint !on;"));
    EXPECT_EQ(none.code, ExitCode::Unknown);
    EXPECT_NE(none.out.find("inconclusive: no inputs satisfy the constraints of both charts"), std::string::npos)
        << none.out;
}

TEST(Compare, ARaceIsAStop) {
    const std::string safe =
        "grafcet r { input a; output L; initial step 0; step 1 { L := true on activation; }\n"
        "    transition t: 0 -> 1 when a; transition u: 1 -> 0 when !a do L := false; }\n";
    const Result result = compared(safe, with(safe, "when a;", "when a do L := false;"));
    EXPECT_EQ(result.code, ExitCode::Verdict);
    EXPECT_NE(result.out.find("[action-race]"), std::string::npos) << result.out;
}

TEST(Compare, StopsByAFaultAndByInstabilityCountAsEqual) {
    const std::string out_of_range =
        "grafcet c {\n    input in;\n    output L;\n    internal n: int 0..5 = 5;\n    initial step 0;\n    step 1 { "
        "L; }\n"
        "    transition t0: 0 -> 1 when true do n := n + 1;\n    transition t1: 0 -> 0 when in;\n}\n";
    const Result result =
        compared(out_of_range, with(out_of_range, "when true do", "when !in do"), {"--mode", "stability-search"});
    EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
    EXPECT_EQ(compared(out_of_range,
                       with(with(out_of_range, "when true do n := n + 1", "when false"), "when in", "when false"))
                  .code,
              ExitCode::Verdict);
}

TEST(Compare, DivisionByZeroIsAStopAsIsTotalInstability) {
    const std::string begin = "grafcet c {\n    input in, n: int 0..1;\n    output L;\n    initial step 0";
    const std::string rest = "    transition t1: 1 -> 0 when in;\n}\n";
    const std::string unstable = begin + ";\n    step 1;\n    step 2 { L; }\n    transition t0: 0 -> 1 when n == 0;\n" +
                                 "    transition t1: 1 -> 0 when n == 0;\n    transition t2: 2 -> 0 when in;\n}\n";
    for (const std::string& dividing :
         {";\n    step 1 { L; }\n    transition t0: 0 -> 1 when 6 / n > 7;\n" + rest,
          ";\n    step 1 { L; }\n    transition t0: 0 -> 1 when rise(6 / n > 7);\n" + rest,
          ";\n    step 1 { L; }\n    transition t0: 0 -> 1 when 2s/(6 / n > 7);\n" + rest,
          " { L if 6 / n > 7; }\n    step 1;\n    transition t0: 0 -> 1 when false;\n" + rest}) {
        SCOPED_TRACE(dividing);
        for (const bool turned : {false, true}) {
            const Result same = turned ? compared(unstable, begin + dividing) : compared(begin + dividing, unstable);
            EXPECT_EQ(same.code, ExitCode::Done) << same.out << same.err;
            EXPECT_NE(same.out.find(": equal\n"), std::string::npos) << same.out;
        }
        const std::string stable = with(unstable, "1 -> 0 when n == 0", "1 -> 0 when false");
        EXPECT_EQ(compared(begin + dividing, stable).code, ExitCode::Verdict) << "one chart stops";
    }
}

TEST(Compare, StoppedComparisonIsUnknown) {
    const std::string station = (root / "samples/testing_station/testing_station.grafcet").string();
    const Result result = grafverif({"compare", station, station, "--chart", "testing_station", "--timeout", "1ms"});
    EXPECT_EQ(result.code, ExitCode::Unknown) << result.out;
    EXPECT_NE(result.out.find("stopped at the time limit of 0"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace grafverif::app
