// SPDX-License-Identifier: MIT
// Tests the options of `compare` for programs, and the messages for programs that cannot be compared.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compare_programs.hpp"

namespace grafverif::app {
namespace {

TEST(CompareOptions, TheOutputForStopsIsStated) {
    const std::string stopping = with(latch, "L : BOOL", "L, Halt : BOOL");
    const Result both = compared(stopping, stopping, {"--stop-output", "HALT"});
    EXPECT_EQ(both.code, ExitCode::Done) << both.err;
    EXPECT_NE(both.out.find("  a stops at the end of a scan if its output `Halt` is not zero; outputs of this scan "
                            "and of later scans are not compared\n"
                            "  b stops at the end of a scan if its output `Halt` is not zero; outputs of this scan "
                            "and of later scans are not compared\n"),
              std::string::npos)
        << both.out;
    const Result one = compared(lamp, stopping, {"--stop-output", "Halt", "--format", "json"});
    EXPECT_EQ(one.code, ExitCode::Done) << one.err;
    EXPECT_EQ(nlohmann::json::parse(one.out)["stop_outputs"], nlohmann::json({nullptr, "Halt"}));
}

TEST(CompareOptions, TheOutputsForStopsCanHaveDifferentNames) {
    const std::string halting =
        with(with(latch, "L : BOOL", "L, Halt : BOOL"), "IF off", "Halt := on AND off;\nIF off");
    const std::string failing = with(with(halting, "L, Halt", "L, Error"), "Halt := on AND off", "Error := off AND on");
    const Result same = compared(halting, failing, {"--stop-output", "halt=Error"});
    EXPECT_EQ(same.code, ExitCode::Done) << same.out << same.err;
    EXPECT_NE(same.out.find("  a stops at the end of a scan if its output `Halt` is not zero; outputs of this scan "
                            "and of later scans are not compared\n"
                            "  b stops at the end of a scan if its output `Error` is not zero; outputs of this scan "
                            "and of later scans are not compared\n"),
              std::string::npos)
        << same.out;
    EXPECT_EQ(compared(failing, halting, {"--stop-output", "Halt=Error"}).code, ExitCode::Input)
        << "a has the output `Error`, not `Halt`";
    const Result other = compared(halting, with(failing, "off AND on", "on"), {"--stop-output", "Halt=Error"});
    EXPECT_EQ(other.code, ExitCode::Verdict) << other.out << other.err;
    EXPECT_NE(other.out.find("in the last scan, only `b` stops\n"), std::string::npos) << other.out;
    // `Halt=Error` names the output that reports a stop in each program; an output of the other program is not
    // accepted.
    const std::string both = with(halting, "L, Halt", "L, Error, Halt");
    const Result left = compared(both, failing, {"--stop-output", "Halt=Error"});
    EXPECT_EQ(left.code, ExitCode::Input) << left.out;
    EXPECT_NE(left.err.find("the output `Error` exists only in `latch` (a)"), std::string::npos) << left.err;
}

TEST(CompareOptions, TheMapAssignsEachNameOnce) {
    const std::string wide = with(latch, "on, off", "on, off, up");
    struct Case {
        std::vector<std::string> options;
        std::string message;
    };
    for (const Case& one : std::vector<Case>{
             {{"--map", "on=off", "--map", "On=on"},
              "`--map on=off` and `--map On=on` assign two names to `on` of `latch` (a); remove one of them"},
             {{"--map", "on=up", "--map", "off=UP"},
              "`--map on=up` and `--map off=UP` assign two names to `up` of `latch` (b); remove one of them"},
             {{"--map", "on=up", "--map", "ON=up"},
              "`--map on=up` and `--map ON=up` are the same assignment; remove one of them"},
             {{"--map", "on=L"},
              "`--map on=L` assigns the input `on` to the output `L`; name two inputs or two outputs"},
             {{"--map", "L=up"},
              "`--map L=up` assigns the output `L` to the input `up`; name two inputs or two outputs"},
             {{"--map", "L=l", "--ignore", "L"},
              "`--ignore L` omits the output `L` of `latch` (a), which `--map L=l` assigns; remove one of these "
              "options"},
             {{"--map", "L=l", "--stop-output", "l"}, "`--stop-output l` omits the output `L` of `latch` (a)"},
         }) {
        SCOPED_TRACE(one.message);
        const Result result = compared(latch, wide, one.options);
        EXPECT_EQ(result.code, ExitCode::Input) << result.out;
        EXPECT_NE(result.err.find(one.message), std::string::npos) << result.err;
        EXPECT_EQ(result.err.find("exists only in"), std::string::npos) << result.err;
    }
    // Names in charts are case-sensitive: `on` and `ON` are two inputs.
    const std::string both = with(lamp, "on, off", "on, off, ON");
    const Result charts = compared(both, both, {"--map", "on=ON", "--map", "ON=on"});
    EXPECT_EQ(charts.code, ExitCode::Verdict) << charts.err;
}

TEST(CompareOptions, NamesAreMatchedWithoutCaseOrByOptions) {
    const std::string upper = with(with(latch, "on, off", "ON, OFF"), "L : BOOL", "l : BOOL");
    EXPECT_EQ(compared(latch, upper).code, ExitCode::Done);
    EXPECT_EQ(compared(lamp, upper).code, ExitCode::Done);
    const std::string german =
        "PROGRAM lampe\nVAR_INPUT ein, aus : BOOL; END_VAR\nVAR_OUTPUT licht : BOOL; END_VAR\n"
        "licht := (licht OR ein) AND NOT aus;\nEND_PROGRAM\n";
    const std::vector<std::string> map = {"--map", "on=EIN", "--map", "off=aus", "--map", "L=licht"};
    const Result mapped = compared(latch, german, map);
    EXPECT_EQ(mapped.code, ExitCode::Done) << mapped.out << mapped.err;
    EXPECT_EQ(compared(lamp, german, map).code, ExitCode::Done);
    EXPECT_EQ(compared(german, lamp, {"--map", "ein=on", "--map", "aus=off", "--map", "licht=L"}).code, ExitCode::Done);
    EXPECT_EQ(compared(latch, german, {"--map", "on=aus", "--map", "off=ein", "--map", "L=licht"}).code,
              ExitCode::Verdict);
    const Result missing = compared(latch, german);
    EXPECT_EQ(missing.code, ExitCode::Input);
    EXPECT_NE(missing.err.find("a:2:"), std::string::npos) << missing.err;
    EXPECT_NE(missing.err.find("the input `on` exists only in `latch`; declare it in both, or pass `--map on=NAME`"),
              std::string::npos)
        << missing.err;
    EXPECT_NE(missing.err.find("the output `licht` exists only in `lampe`"), std::string::npos) << missing.err;
}

TEST(CompareOptions, WhatCannotBeComparedIsRejectedWithARemedy) {
    struct Case {
        std::string a, b;
        std::vector<std::string> options;
        std::string message;
    };
    const std::string wide =
        "PROGRAM p\nVAR_INPUT on : BOOL; n : INT; END_VAR\nVAR_OUTPUT L : BOOL; END_VAR\n"
        "L := on AND n > 3;\nEND_PROGRAM\n";
    const std::string task = every(delay, "delay", "T#500ms"), real = with(latch, "L : BOOL", "r : REAL; L : BOOL");
    const std::string colours =
        "TYPE Colour : (Red, Green); END_TYPE\nPROGRAM p\nVAR_OUTPUT c : Colour; END_VAR\nc := Red;\nEND_PROGRAM\n";
    for (const Case& one : std::vector<Case>{
             {wide,
              with(wide, "n : INT", "n : DINT"),
              {},
              "the input `n` is an integer from -32768 to 32767 in `p` (a) and an "
              "integer from -2147483648 to 2147483647 in `p` (b); declare it "
              "with the same type in both"},
             {wide, with(with(wide, "n : INT", "n : BOOL"), "n > 3", "n"), {}, "the input `n` is an integer"},
             {colours,
              with(colours, "Green)", "Blue)"),
              {},
              "value 2 of the enumeration of the output `c` is `Green` in `p` (a) and `Blue` in `p` (b); declare the "
              "same "
              "values in the same order in both"},
             {colours,
              with(colours, "Green)", "Green, Blue)"),
              {},
              "value 3 of the enumeration of the output `c` is missing in `p` (a) and `Blue` in `p` (b)"},
             {"grafcet g { output c: int 0..1; initial step 0; }\n",
              colours,
              {},
              "the output `c` is an integer from 0 to 1 in `g` and an enumeration in `p`; declare it as an integer in "
              "the "
              "program"},
             {wide, with(with(wide, "n : INT", "n : TIME"), "n > 3", "n > T#3ms"), {}, "a duration in `p` (b)"},
             {latch, with(latch, "L : BOOL", "M : BOOL; L : BOOL"), {}, "the output `M` exists only in `latch` (b)"},
             {latch, latch, {"--ignore", "L"}, "`latch` has no outputs and cannot be compared"},
             {latch,
              latch,
              {"--ignore", "K"},
              "`--ignore K` does not name an output of the compared files; name an output"},
             {latch, latch, {"--stop-output", "K"}, "`--stop-output K` does not name an output of a program"},
             {latch, latch, {"--stop-output", "=L"}, "invalid value `=L` of `--stop-output`; use NAME or NAME=NAME"},
             {latch,
              latch,
              {"--stop-output", "L=K"},
              "`--stop-output L=K` requires a program with the output `K`, but `latch` (b) is not such a program; name "
              "an output of "
              "each program; pass one NAME if only one program has such an output"},
             {lamp, latch, {"--stop-output", "L=L"}, "a program with the output `L`, but `lamp` is not such a program"},
             {latch, real, {"--stop-output", "r"}, "`--stop-output r` names an output of a type that is not supported"},
             {latch,
              latch,
              {"--stop-output", "L", "--ignore", "l"},
              "`--ignore l` omits the output `L` of `latch` (a), which reports a stop according to `--stop-output L`; "
              "remove one of these options"},
             {latch,
              real,
              {"--map", "L=R"},
              "`--map L=R` assigns the output `R` of `latch` (b), but the type of this output is not supported; use "
              "another type, or pass `--ignore R` instead"},
             {latch, latch, {"--map", "of=off"}, "input or output `of`"},
             {latch, latch, {"--map", "off"}, "invalid value `off` of `--map`; use NAME=NAME"},
             {latch, latch, {"--mode", "every-cycle"}, "`--mode` applies to charts, but both files are programs"},
             {latch, lamp, {"--from-situation", "0"}, "`--from-situation` applies to charts, but a file is a program"},
             {lamp, lamp, {"--compare", "settled"}, "`--compare settled` applies to programs"},
             {lamp, latch, {"--compare", "settled", "--mode", "every-cycle"}, "requires the mode `stability-search`"},
             {task,
              every(delay, "delay", "T#1s"),
              {},
              "the task of `delay` (a) is executed every 500 ms, and that of `delay` (b) "
              "every 1000 ms; give both tasks the same INTERVAL"},
             {task,
              delay,
              {"--resolution", "500ms"},
              "`--resolution` cannot be used, because the task of `delay` (a) is "
              "executed every 500 ms"},
             {task, delay, {"--compare", "settled"}, "`--compare settled` cannot be used"},
             {latch, "PROGRAM p\nVAR x : LREAL; END_VAR\nx := x + 1.0;\nEND_PROGRAM\n", {}, "b:3:"},
             {latch, "PROGRAM p\nVAR x : BOOL; END_VAR\nx := ;\nEND_PROGRAM\n", {}, "b:3:"},
             {latch,
              real,
              {},
              "the type of the output `r` is not supported; use another type, or pass `--ignore r` [not-comparable]"},
             {latch, "PROGRAM", {}, "b:1:"},
             {latch, "<project", {}, "b:1:"},
             {latch, "(* only a comment *)", {}, "error"},
         }) {
        SCOPED_TRACE(one.message);
        const Result result = compared(one.a, one.b, one.options);
        EXPECT_EQ(result.code, ExitCode::Input) << result.out << result.err;
        EXPECT_NE(result.err.find(one.message), std::string::npos) << result.err;
        EXPECT_EQ(result.out, "");
    }
}

TEST(CompareOptions, OutputsThatCannotBeComparedAreRejected) {
    const std::string block =
        "FUNCTION_BLOCK F\nVAR_INPUT x : BOOL; END_VAR\nVAR y AT %Q* : BOOL; r AT %Q* : REAL; END_VAR\n"
        "y := x; r := 1.0;\nEND_FUNCTION_BLOCK\nPROGRAM Main\nVAR_INPUT x : BOOL; END_VAR VAR_OUTPUT q : BOOL; "
        "END_VAR\n"
        "VAR f : F; END_VAR\nq := x; f(x := x);\nEND_PROGRAM\n";
    const Result real = compared(block, with(block, "r := 1.0", "r := 2.0"));
    EXPECT_EQ(real.code, ExitCode::Input) << real.out;
    EXPECT_NE(real.err.find("`--ignore F.r`"), std::string::npos) << real.err;
    EXPECT_EQ(compared(block, with(block, "r := 1.0", "r := 2.0"), {"--ignore", "f.r"}).code, ExitCode::Done);
    const std::string constant =
        "PROGRAM Main\nVAR_INPUT x : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\n"
        "VAR_OUTPUT CONSTANT k : INT := 1; END_VAR\nq := x;\nEND_PROGRAM\n";
    const Result other = compared(constant, with(constant, "k : INT := 1", "k : INT := 2"));
    EXPECT_EQ(other.code, ExitCode::Input) << other.out;
    EXPECT_NE(other.err.find("the output `k` is a constant, which is not compared; remove CONSTANT"), std::string::npos)
        << other.err;
}

}  // namespace
}  // namespace grafverif::app
