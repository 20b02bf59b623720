// SPDX-License-Identifier: MIT
// Tests `check --why` for PLC programs, without a plant and as controllers of closed loops. For programs with one
// statement per line, the result is compared with the verdicts on the programs whose texts lack one
// line.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "compare_programs.hpp"

namespace grafverif::app {
namespace {

using Json = nlohmann::json;

const std::string motor =
    "PROGRAM motor\n"
    "VAR_INPUT go, stop : BOOL; END_VAR\n"
    "VAR_OUTPUT run, lamp : BOOL; END_VAR\n"
    "VAR n : INT; late : TON; a, b : ARRAY[0..2] OF BOOL; END_VAR\n"
    "IF go THEN\n"
    "  run := TRUE;\n"
    "END_IF\n"
    "a := b;\n"
    "IF stop THEN\n"
    "  n := 5;\n"
    "  run := FALSE;\n"
    "END_IF\n"
    "lamp := run;\n"
    "END_PROGRAM\n";
const std::string motor_properties =
    "properties:\n"
    "  - {id: safe, kind: invariant, expression: \"NOT (stop AND run)\"}\n"
    "  - {id: lit, kind: invariant, expression: \"lamp = run\"}\n"
    "  - {id: on, kind: reachable, expression: \"run\"}\n"
    "  - {id: bad, kind: invariant, expression: \"n = 0\"}\n";

TEST(WhyOfProgram, StatementsAreNamedWithTheirLines) {
    const Folder folder;
    const std::string program = folder.write("motor.st", motor), yaml = folder.write("motor.yaml", motor_properties);
    const Result text = grafverif({"check", program, "--properties", yaml, "--why"});
    EXPECT_EQ(text.code, ExitCode::Verdict) << text.err;
    EXPECT_TRUE(
        text.out.ends_with("\n"
                           "proof dependencies (5 additional searches):\n"
                           "safe: fails without `run := FALSE` of line 11\n"
                           "lit: fails without `lamp := run` of line 13\n"
                           "on: fails without `run := TRUE` of line 6\n"
                           "\n"
                           "proof coverage of these properties:\n"
                           "statements: 3 of 5; no property fails without `a[0] := b[0]` of line 8 or `n := 5` of line "
                           "10\n"))
        << text.out;
    const Json why =
        Json::parse(grafverif({"check", program, "--properties", yaml, "--why", "--format", "json"}).out)["why"];
    EXPECT_EQ(why["coverage"][0], Json({{"kind", "statement"},
                                        {"name", "run := TRUE"},
                                        {"of", "line 6"},
                                        {"needed_by", {"on"}},
                                        {"open", Json::array()}}));
}

TEST(WhyOfProgram, TransitionsOfSequentialFunctionChartsAreElements) {
    const Folder folder;
    const std::string spindle =
        "PROGRAM spindle\nVAR_INPUT go : BOOL; END_VAR\nVAR_OUTPUT run : BOOL; n : INT; END_VAR\n"
        "INITIAL_STEP Idle: END_STEP\nSTEP Turning: run(N); Add(P1); END_STEP\n"
        "TRANSITION FROM Idle TO Turning := go; END_TRANSITION\n"
        "TRANSITION stop FROM Turning TO Idle := NOT go; END_TRANSITION\n"
        "ACTION Add: n := n + 1; END_ACTION\nEND_PROGRAM\n";
    const std::string program = folder.write("spindle.st", spindle);
    const std::string yaml = folder.write("spindle.yaml",
                                          "properties:\n"
                                          "  - {id: on, kind: reachable, expression: \"run\"}\n"
                                          "  - {id: twice, kind: reachable, expression: \"n = 2\"}\n");
    const Result text = grafverif({"check", program, "--properties", yaml, "--why"});
    EXPECT_EQ(text.code, ExitCode::Done) << text.out << text.err;
    EXPECT_NE(text.out.find("on: fails if Idle -> Turning is never cleared, or without `action run` of line 5\n"
                            "twice: fails if Idle -> Turning or stop is never cleared, or without `n := n + 1` of line "
                            "8\n"),
              std::string::npos)
        << text.out;
}

TEST(WhyOfProgram, ProgramsOfLoopsHaveElements) {
    const Folder folder;
    folder.write("motor.st", motor);
    const std::string loop = folder.write(
        "loop.grafcet",
        "program motor = \"motor.st\";\n"
        "closed_loop l {\n    controller motor every 10ms;\n    environment Go = free(OUT = go);\n"
        "    environment Stop = free(OUT = stop);\n    property lit: always lamp && run || !lamp && !run;\n"
        "    property on: reachable run;\n}\n");
    const Result text = grafverif({"check", loop, "--why"});
    EXPECT_EQ(text.code, ExitCode::Done) << text.out << text.err;
    EXPECT_NE(text.out.find("lit: fails without `lamp := run` of line 13; holds for any behaviour of the plant and the "
                            "timers\n"
                            "on: fails without `run := TRUE` of line 6\n"),
              std::string::npos)
        << text.out;
    EXPECT_NE(text.out.find("statements: 2 of 5; no property fails without"), std::string::npos) << text.out;
}

TEST(WhyOfProgram, ALoopWithoutAConstantBoundIsUndecided) {
    const Folder folder;
    const std::string program = folder.write("count.st",
                                             "PROGRAM count\nVAR_OUTPUT n : INT; END_VAR\nVAR i : INT; END_VAR\n"
                                             "i := 0;\nn := 0;\nWHILE i < 3 DO\n  n := n + 1;\n  i := i + 1;\n"
                                             "END_WHILE;\nEND_PROGRAM\n");
    const std::string yaml =
        folder.write("count.yaml", "properties:\n  - {id: three, kind: invariant, expression: \"n = 3 OR n = 0\"}\n");
    const Result text = grafverif({"check", program, "--properties", yaml, "--why"});
    EXPECT_EQ(text.code, ExitCode::Done) << text.out << text.err;
    EXPECT_NE(text.out.find("undecided: statement `i := 0` of line 4, statement `i\n    := i + 1` of line 8"),
              std::string::npos)
        << text.out;
}

/// Returns the outcome of each property.
std::map<std::string, std::string> outcomes(const std::string& program, const std::string& yaml) {
    std::map<std::string, std::string> found;
    const Json report =
        Json::parse(grafverif({"check", program, "--properties", yaml, "--format", "json"}).out, nullptr, false);
    if (!report.is_discarded())
        for (const Json& one : report["properties"]) found[one["name"]] = one["verdict"];
    return found;
}

TEST(WhyOfProgram, ResultIsThatOfTheTextWithoutTheLine) {
    const Folder folder;
    const std::string drive = (root / "docs/drive.st").string(), yaml = (root / "docs/drive.yaml").string();
    std::string text;
    {
        std::ifstream in(drive);
        text.assign(std::istreambuf_iterator<char>(in), {});
    }
    int compared_lines = 0, needed = 0;
    const Json why =
        Json::parse(grafverif({"check", drive, "--properties", yaml, "--why", "--format", "json"}).out)["why"];
    std::map<std::string, int> elements;
    for (const Json& one : why["coverage"]) ++elements[one["of"]];
    for (const Json& one : why["coverage"]) {
        if (elements[one["of"]] > 1) continue;
        std::size_t begin = 0;
        for (int line = std::stoi(one["of"].get<std::string>().substr(5)); line > 1; --line)
            begin = text.find('\n', begin) + 1;
        std::string less = text;
        less.erase(begin, text.find('\n', begin) - begin);
        const auto found = outcomes(folder.write("less.st", less), yaml);
        for (const Json& property : why["properties"]) {
            const bool is_needed = std::ranges::find(one["needed_by"], property["property"]) != one["needed_by"].end();
            EXPECT_EQ(found.at(property["property"]) != "holds", is_needed) << one << property << less;
            needed += is_needed ? 1 : 0;
            ++compared_lines;
        }
    }
    EXPECT_GT(compared_lines, 10);
    EXPECT_GT(needed, 2);
}

}  // namespace
}  // namespace grafverif::app
