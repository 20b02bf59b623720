// SPDX-License-Identifier: MIT
// Tests `compare` with PLC programs: equal, different and faulty programs.
#include "compare_programs.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace grafverif::app {
namespace {

TEST(ComparePrograms, RewrittenProgramIsProvedEqual) {
    const std::string other =
        with(latch, "IF on THEN L := TRUE; END_IF;\nIF off THEN L := FALSE; END_IF;", "L := (L OR on) AND NOT off;");
    const Result result = compared(latch, other);
    EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
    EXPECT_EQ(result.out,
              "`latch` (a) and `latch` (b): equal\n"
              "  for all inputs, a and b write the same outputs in every scan, or both stop in the same scan\n"
              "  a scan is one execution of each program\n");
    EXPECT_EQ(compared(latch, latch).code, ExitCode::Done);
    const std::string real = with(latch, "L : BOOL", "r : REAL; L : BOOL");
    const Result ignored = compared(latch, real, {"--ignore", "r"});
    EXPECT_EQ(ignored.code, ExitCode::Done) << ignored.err;
    EXPECT_NE(ignored.out.find("  these outputs are not compared: `r`\n"), std::string::npos) << ignored.out;
}

TEST(ComparePrograms, DifferenceIsTheShortestSequenceWithBothOutputs) {
    const Result result = compared(latch, with(latch, "IF off", "IF off AND NOT on"));
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
    EXPECT_EQ(result.out,
              "`latch` (a) and `latch` (b): different\n"
              "  distinguished by 1 scan, the minimum, replayed by the program interpreter:\n"
              "  time  inputs   a writes  b writes\n"
              "  0 s   on, off  none      L\n"
              "  in the last scan, the programs differ in `L`\n"
              "  a scan is one execution of each program\n");
    const Result late = compared(counter, with(counter, "q := q + 1", "q := (q + 1) MOD 3"), {"--format", "json"});
    EXPECT_EQ(late.code, ExitCode::Verdict) << late.out << late.err;
    const auto json = nlohmann::json::parse(late.out);
    EXPECT_EQ(json["programs"], nlohmann::json({true, true}));
    EXPECT_EQ(json["shortest"], true);
    ASSERT_EQ(json["scans"].size(), 5U) << "q counts three edges";
    EXPECT_EQ(json["scans"].back()["answers"][0]["outputs"]["q"], 3);
    EXPECT_EQ(json["scans"].back()["answers"][1]["outputs"]["q"], 0);
    EXPECT_TRUE(json["scans"].back()["answers"][0]["situation"].is_null());
}

TEST(ComparePrograms, AChartIsComparedWithAProgramInBothOrders) {
    for (const bool turned : {false, true}) {
        const Result same = turned ? compared(latch, lamp) : compared(lamp, latch);
        EXPECT_EQ(same.code, ExitCode::Done) << same.out << same.err;
        EXPECT_NE(same.out.find("a scan is one PLC cycle of the chart, mode stability-search, and one execution of the "
                                "program\n"),
                  std::string::npos)
            << same.out;
        const std::string wrong = with(latch, "IF off", "IF off AND NOT on");
        const Result apart = turned ? compared(wrong, lamp) : compared(lamp, wrong);
        EXPECT_EQ(apart.code, ExitCode::Verdict) << apart.out << apart.err;
        EXPECT_NE(apart.out.find("distinguished by 1 scan, the minimum, replayed under the rules of IEC 60848 and "
                                 "by the program interpreter"),
                  std::string::npos)
            << apart.out;
    }
    // The first scan of a chart in every-cycle mode activates the initial steps only.
    EXPECT_EQ(compared(lamp, latch, {"--mode", "every-cycle"}).code, ExitCode::Verdict);
}

TEST(ComparePrograms, StructuredTextOfAChartIsEqualToIt) {
    const Folder folder;
    const std::string chart = folder.write(
        "lamp.grafcet",
        with(with(with(lamp, "on, off", "go, off"), "when on", "when go"), "when off", "when off || 2s/X1"));
    const std::string program = folder.file("lamp.st");
    for (const std::string mode : {"every-cycle", "stability-search"}) {
        ASSERT_EQ(
            grafverif({"st", chart, "--format", "text", "--mode", mode, "--max-evolutions", "5", "-o", program}).code,
            ExitCode::Done);
        const Result result =
            grafverif({"compare", chart, program, "--mode", mode, "--stop-output", "FAULT", "--resolution", "1s"});
        EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
        EXPECT_NE(result.out.find("scans occur at arbitrary multiples of 1s"), std::string::npos) << result.out;
    }
    const Result fault = grafverif({"compare", chart, program});
    EXPECT_EQ(fault.code, ExitCode::Input);
    EXPECT_NE(
        fault.err.find("the output `FAULT` exists only in `lamp` (b); declare it in both, or pass `--map NAME=FAULT` "
                       "or `--ignore FAULT` or `--stop-output FAULT` [not-comparable]"),
        std::string::npos)
        << fault.err;
    EXPECT_EQ(grafverif({"compare", chart, program, "--ignore", "fault", "--resolution", "1s"}).code, ExitCode::Done);
}

TEST(ComparePrograms, ARunTimeFaultInWhichBothStopIsAModelError) {
    const std::string dividing = with(counter, "IF e.Q", "IF a THEN q := q + 6 / n; END_IF;\nIF e.Q");
    const Result result = compared(dividing, with(dividing, "6 / n", "6 / (n + 0)"));
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.out << result.err;
    EXPECT_NE(
        result.out.find(
            "unknown\n"
            "  inconclusive: in the last scan, a and b both stop because of a run-time fault, which is a "
            "model error\n"
            "  proved: for all inputs, a and b write the same outputs in every scan, or both stop in the same scan\n"
            "  found: a run-time fault in scan 1, replayed by the program interpreter:\n"),
        std::string::npos)
        << result.out;
    const Result exact = compared(dividing, dividing, {"--format", "json"});
    const auto json = nlohmann::json::parse(exact.out);
    EXPECT_EQ(json["outcome"], "unknown");
    EXPECT_EQ(json["faulty"], true);
    const std::string stop = json["scans"].back()["answers"][1]["stop"];
    EXPECT_TRUE(stop.starts_with("the program divides by zero (")) << stop;
    EXPECT_TRUE(stop.ends_with("b:6) [no-value]")) << stop;
    EXPECT_NE(result.out.find("in the last scan, a and b both stop\n"), std::string::npos) << result.out;
    EXPECT_EQ(compared(dividing, dividing).code, ExitCode::Verdict) << "also for identical programs";
    const Result one = compared(dividing, with(dividing, "IF a THEN", "IF a AND n > 0 THEN"));
    EXPECT_EQ(one.code, ExitCode::Verdict);
    EXPECT_NE(one.out.find("in the last scan, only `a` stops"), std::string::npos) << one.out;
    const std::string array = with(latch, "L : BOOL; END_VAR",
                                   "L : BOOL; END_VAR VAR_INPUT i : USINT; END_VAR "
                                   "VAR v : ARRAY[0..3] OF BOOL; END_VAR v[i] := on;");
    EXPECT_NE(compared(array, array, {"--format", "json"}).out.find("the program uses an index outside of its array"),
              std::string::npos);
}

TEST(ComparePrograms, AFaultAfterAStopHasNoEffect) {
    const std::string stopping =
        "PROGRAM p\nVAR_INPUT a : BOOL; n : USINT; END_VAR\nVAR_OUTPUT S : BOOL; q : INT; END_VAR\n"
        "IF S THEN q := 6 / n; END_IF;\nS := S OR a;\nEND_PROGRAM\n";
    const std::string other = with(stopping, "6 / n", "6 / (n + 0)");
    for (const std::string mode : {"scans", "settled"}) {
        const Result after = compared(stopping, other, {"--stop-output", "S", "--compare", mode});
        EXPECT_EQ(after.code, ExitCode::Done) << after.out << after.err;
    }
    EXPECT_NE(compared(stopping, other).out.find("both stop because of a run-time fault"), std::string::npos);
}

TEST(ComparePrograms, TheSideWithARunTimeFaultIsNamed) {
    const std::string faulty =
        "PROGRAM p\nVAR_INPUT a : BOOL; n : USINT; END_VAR\nVAR_OUTPUT S : BOOL; q : INT; END_VAR\n"
        "IF a AND n = 0 THEN q := 6 / n; END_IF;\nEND_PROGRAM\n";
    const std::string stopping = with(faulty, "q := 6 / n", "S := TRUE");
    for (const bool turned : {false, true}) {
        const Result result = turned ? compared(stopping, faulty, {"--stop-output", "S"})
                                     : compared(faulty, stopping, {"--stop-output", "S"});
        EXPECT_EQ(result.code, ExitCode::Verdict) << result.out << result.err;
        EXPECT_NE(result.out.find(turned ? "both stop, b because of a run-time fault, which is a model error\n"
                                         : "both stop, a because of a run-time fault, which is a model error\n"),
                  std::string::npos)
            << result.out;
        EXPECT_NE(result.out.find("`S` is not"), std::string::npos) << result.out;
    }
}

TEST(ComparePrograms, AStopInTheFirstScanMakesTheResultUnknown) {
    const std::string on =
        "PROGRAM p\nVAR_INPUT on : BOOL; END_VAR\nVAR_OUTPUT OK, L : BOOL; END_VAR\n"
        "OK := TRUE; L := on;\nEND_PROGRAM\n";
    for (const std::string mode : {"scans", "settled"}) {
        const Result result =
            compared(on, with(on, "L := on", "L := FALSE"), {"--stop-output", "OK", "--compare", mode});
        EXPECT_EQ(result.code, ExitCode::Unknown) << result.out << result.err;
        EXPECT_NE(result.out.find("a and b both stop in the first scan for all inputs, so no outputs are compared"),
                  std::string::npos)
            << result.out;
    }
}

TEST(ComparePrograms, AStopMakesTheResultUnknownIfTheOtherDoesNotSettle) {
    const std::string stopping =
        "PROGRAM p\nVAR_INPUT on : BOOL; END_VAR\nVAR_OUTPUT S, L : BOOL; END_VAR\n"
        "IF on THEN S := TRUE; END_IF;\nEND_PROGRAM\n";
    const std::string other = with(stopping, "S := TRUE", "L := NOT L");
    for (const bool turned : {false, true}) {
        const Result result = compared(turned ? other : stopping, turned ? stopping : other,
                                       {"--stop-output", "S", "--compare", "settled"});
        EXPECT_EQ(result.code, ExitCode::Unknown) << result.out << result.err;
        EXPECT_NE(result.out.find("one side stops and the outputs of the other side do not settle"), std::string::npos)
            << result.out;
    }
}

const std::string heater =
    "TYPE Mode : (Idle, Heating); END_TYPE\nPROGRAM heater\nVAR_INPUT on : BOOL; END_VAR\n"
    "VAR_OUTPUT m : Mode; t : TIME; END_VAR\n"
    "IF on THEN m := Heating; t := T#1s500ms; ELSE m := Idle; t := T#2s; END_IF;\nEND_PROGRAM\n";

TEST(ComparePrograms, DurationsAndEnumerationsArePrintedAsInPrograms) {
    const std::string wrong = with(heater, "m := Heating; t := T#1s500ms", "m := Idle; t := T#1s");
    const Result result = compared(heater, wrong);
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
    EXPECT_NE(result.out.find("  0 s   on      m = Heating, t = T#1500ms  m = Idle, t = T#1s\n"), std::string::npos)
        << result.out;
    const auto json = nlohmann::json::parse(compared(heater, wrong, {"--format", "json"}).out);
    EXPECT_EQ(json["scans"][0]["answers"][0]["outputs"], nlohmann::json({{"m", "Heating"}, {"t", 1500}}));
}

TEST(ComparePrograms, EnumerationsAreComparedWithoutRegardToCase) {
    const std::string upper = with(with(heater, "(Idle, Heating)", "(IDLE, heating)"), "m := Idle", "m := idle");
    const Result same = compared(heater, upper);
    EXPECT_EQ(same.code, ExitCode::Done) << same.out << same.err;
    const Result apart = compared(heater, with(upper, "m := Heating", "m := IDLE"));
    EXPECT_EQ(apart.code, ExitCode::Verdict) << apart.err;
    EXPECT_NE(apart.out.find("m = Heating, t = T#1500ms  m = Idle, t = T#1500ms\n"), std::string::npos) << apart.out;
}

TEST(ComparePrograms, TheTimeBetweenScansIsStated) {
    const Result any = compared(delay, with(delay, "T#2s", "T#1s"), {"--format", "json"});
    EXPECT_EQ(any.code, ExitCode::Verdict) << any.err;
    auto json = nlohmann::json::parse(any.out);
    EXPECT_EQ(json["resolution_ms"], 1);
    EXPECT_TRUE(json["interval_ms"].is_null());
    EXPECT_EQ(json["scans"].size(), 2U);
    const std::string task = every(delay, "delay", "T#500ms");
    const Result fixed = compared(task, with(delay, "T#2s", "T#1s"), {"--format", "json"});
    EXPECT_EQ(fixed.code, ExitCode::Verdict) << fixed.err;
    json = nlohmann::json::parse(fixed.out);
    EXPECT_EQ(json["interval_ms"], 500);
    ASSERT_EQ(json["scans"].size(), 3U) << fixed.out;
    EXPECT_EQ(json["scans"].back()["time_ms"], 1000);
    EXPECT_NE(compared(task, task).out.find("; scans occur every 500ms\n"), std::string::npos);
    // With an interval of 500 ms, 1800 ms elapse in the same scan as 2 s.
    EXPECT_EQ(compared(task, with(task, "T#2s", "T#1800ms")).code, ExitCode::Done);
    EXPECT_EQ(compared(delay, with(delay, "T#2s", "T#1800ms")).code, ExitCode::Verdict);
    EXPECT_EQ(compared(delay, with(delay, "T#2s", "T#1800ms"), {"--resolution", "500ms"}).code, ExitCode::Done);
    const std::string chart = "grafcet d { input a; output q; initial step 0 { q if 2s/a; } }\n";
    EXPECT_EQ(compared(chart, delay, {"--mode", "every-cycle", "--resolution", "500ms"}).code, ExitCode::Done);
    const Result late = compared(chart, with(delay, "T#2s", "T#2001ms"), {"--mode", "every-cycle"});
    EXPECT_EQ(late.code, ExitCode::Verdict) << late.out << late.err;
}

TEST(ComparePrograms, SettledOutputsAreCompared) {
    const std::string slow =
        "PROGRAM slow\nVAR_INPUT on, off : BOOL; END_VAR\nVAR_OUTPUT L : BOOL; END_VAR\n"
        "VAR m : BOOL; END_VAR\nL := m;\nm := (m OR on) AND NOT off;\nEND_PROGRAM\n";
    EXPECT_EQ(compared(latch, slow).code, ExitCode::Verdict) << "the output is one scan late";
    for (const std::string& other : {latch, lamp}) {
        const Result settled = compared(other, slow, {"--compare", "settled"});
        EXPECT_EQ(settled.code, ExitCode::Done) << settled.out << settled.err;
        EXPECT_NE(settled.out.find("repeated with constant inputs and without delay until nothing changes\n"),
                  std::string::npos)
            << settled.out;
    }
    const Result apart = compared(latch, with(slow, "AND NOT off", ""), {"--compare", "settled"});
    EXPECT_EQ(apart.code, ExitCode::Verdict) << apart.out << apart.err;
    const std::string blinking = with(slow, "(m OR on) AND NOT off", "NOT m");
    const Result never = compared(latch, blinking, {"--compare", "settled", "--format", "json"});
    EXPECT_EQ(never.code, ExitCode::Verdict) << never.out << never.err;
    EXPECT_NE(never.out.find("the program repeats its states forever [total-instability]"), std::string::npos)
        << never.out;
    const Result neither = compared(blinking, blinking, {"--compare", "settled"});
    EXPECT_EQ(neither.code, ExitCode::Unknown) << neither.out << neither.err;
    EXPECT_NE(neither.out.find("the outputs of neither program settle"), std::string::npos) << neither.out;
}

TEST(ComparePrograms, TextualChartIsComparedAsAProgram) {
    const std::string sfc =
        "PROGRAM s\nVAR_INPUT on, off : BOOL; END_VAR\nVAR_OUTPUT L : BOOL; END_VAR\n"
        "INITIAL_STEP s0: END_STEP\nSTEP s1: L(N); END_STEP\nTRANSITION FROM s0 TO s1 := on AND NOT off; "
        "END_TRANSITION\nTRANSITION FROM s1 TO s0 := off; END_TRANSITION\nEND_PROGRAM\n";
    const Result result = compared(lamp, sfc, {"--mode", "every-cycle"});
    EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
    EXPECT_EQ(compared(lamp, sfc).code, ExitCode::Verdict) << "the first execution clears no transition";
    EXPECT_EQ(compared(lamp, sfc, {"--imported-charts"}).code, ExitCode::Done);
}

TEST(ComparePrograms, AnInputOfAProgramTakesTheValuesOfTheChart) {
    const std::string chart = "grafcet c { input n: int 0..3; output L; initial step 0 { L if n > 2; } }\n";
    const std::string program =
        "PROGRAM p\nVAR_INPUT n : INT; END_VAR\nVAR_OUTPUT L : BOOL; END_VAR\n"
        "L := n = 3;\nEND_PROGRAM\n";
    for (const bool turned : {false, true}) {
        const Result same = turned ? compared(program, chart) : compared(chart, program);
        EXPECT_EQ(same.code, ExitCode::Done) << same.out << same.err;
        EXPECT_NE(
            same.out.find("  these inputs of the program are restricted to the ranges of the chart's inputs: `n`\n"),
            std::string::npos)
            << same.out;
    }
    EXPECT_EQ(compared(chart, with(program, "n : INT", "n : USINT(1..3)")).code, ExitCode::Input);
}

TEST(ComparePrograms, StoppedComparisonIsUnknown) {
    const std::string hard = with(counter, "q := q + 1;", "q := q * q + 3;");
    const Result result = compared(hard, with(hard, "q * q + 3", "3 + q * q"), {"--timeout", "1ms"});
    EXPECT_EQ(result.code, ExitCode::Unknown) << result.out;
    EXPECT_NE(result.out.find("inconclusive: "), std::string::npos) << result.out;
}

}  // namespace
}  // namespace grafverif::app
