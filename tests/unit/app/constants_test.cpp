// SPDX-License-Identifier: MIT
// Tests named constants of a closed loop, and `--set`.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

const std::string filling_chart =
    "grafcet filling {\n    input START, FULL;\n    output COARSE, FINE;\n\n    initial step 0;\n"
    "    step 1 { COARSE; }\n    step 2 { FINE; }\n\n    transition t0: 0 -> 1 when START;\n"
    "    transition t1: 1 -> 2 when 2s/X1;\n    transition t2: 2 -> 0 when FULL;\n}\n\n";
const std::string plant =
    "    controller filling;\n    environment S = free(OUT = START);\n    environment F = free(OUT = FULL);\n"
    "    plant Main = valve(ORDER = COARSE or FINE, FLOW = FLOW, TRAVEL = N * UNIT);\n";
const std::string tank =
    filling_chart + "closed_loop tank {\n    constant N: int 1..8 = 2, UNIT = 1s;\n    constant TWICE = 2 * N;\n" +
    plant + "    property small: never TWICE > 8;\n    property prompt: COARSE leads to FLOW or X0 within 2s;\n}\n";

nlohmann::json checked_with(const std::string& file, const std::vector<std::string>& settings) {
    std::vector<std::string> arguments{"check", file, "--format", "json"};
    for (const std::string& each : settings) arguments.insert(arguments.end(), {"--set", each});
    const Result result = grafverif(arguments);
    EXPECT_EQ(result.err, "");
    return nlohmann::json::parse(result.out, nullptr, false);
}

std::string verdict(const nlohmann::json& report, const std::string& name) {
    for (const auto& property : report["properties"])
        if (property["name"] == name) return property["verdict"];
    return "none";
}

TEST(Constants, AreReplacedByTheirValues) {
    const Folder folder;
    const std::string file = folder.write("tank.grafcet", tank);
    const auto as_written = checked_with(file, {});
    EXPECT_EQ(verdict(as_written, "small"), "holds");
    EXPECT_EQ(verdict(as_written, "prompt"), "holds");
    EXPECT_EQ(as_written["constants"], nlohmann::json::parse(R"([{"name": "N", "value": 2, "set": false},
                                        {"name": "UNIT", "value": "1s", "set": false},
                                        {"name": "TWICE", "value": 4, "set": false}])"));
    const auto set = checked_with(file, {"N=5", "UNIT=500ms"});
    EXPECT_EQ(verdict(set, "small"), "violated");
    EXPECT_EQ(verdict(set, "prompt"), "violated");  // the constant is 2.5 s
    EXPECT_EQ(set["constants"][0], nlohmann::json::parse(R"({"name": "N", "value": 5, "set": true})"));
    EXPECT_EQ(set["constants"][2], nlohmann::json::parse(R"({"name": "TWICE", "value": 10, "set": false})"));
}

TEST(Constants, AreShownWithVerdictsAndInEveryModel) {
    const Folder folder;
    const std::string file = folder.write("tank.grafcet", tank);
    const std::string words = "N = 3 (set), UNIT = 1s, TWICE = 6";
    for (const std::vector<std::string>& verb :
         std::vector<std::vector<std::string>>{{"check"},
                                               {"check", "--untimed", "--plant", "automata", "--property", "small"},
                                               {"uppaal"},
                                               {"nusmv"},
                                               {"nusmv", "--plant", "automata"},
                                               {"pins"},
                                               {"btor2", "--plant", "automata"},
                                               {"report"}}) {
        std::vector<std::string> arguments = verb;
        arguments.insert(arguments.end(), {file, "--set", "N=3"});
        const Result result = grafverif(arguments);
        EXPECT_NE(result.out.find(words), std::string::npos) << verb[0] << '\n'
                                                             << result.err << result.out.substr(0, 900);
    }
}

TEST(Constants, ThatALoopDoesNotHaveCannotBeSet) {
    const Folder folder;
    const std::string two = filling_chart + "closed_loop tank {\n    constant N = 2, UNIT = 1s;\n" + plant + "}\n" +
                            "closed_loop other {\n    constant COUNT = 2, N = 1, UNIT = 1s;\n" + plant + "}\n";
    const std::string file = folder.write("tank.grafcet", two);
    const auto output = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"check", file});
        const Result result = grafverif(arguments);
        EXPECT_EQ(result.code, ExitCode::Input);
        return result.err;
    };
    EXPECT_NE(output({"--loop", "other", "--set", "CONT=3"}).find("did you mean `COUNT`?"), std::string::npos);
    EXPECT_NE(output({"--loop", "tank", "--set", "COUNT=3"}).find("`tank` has no constant `COUNT`"), std::string::npos);
    EXPECT_NE(output({"--loop", "tank", "--set", "N=3s"}).find("cannot be set to `3s`; write `--set N=4`"),
              std::string::npos);
    EXPECT_EQ(grafverif({"check", file, "--set", "N"}).code, ExitCode::Input);
    EXPECT_EQ(grafverif({"check", file, "--set", "N=1", "--set", "N=2"}).code, ExitCode::Input);
    EXPECT_EQ(grafverif({"check", file, "--all", "--set", "COUNT=3", "--quiet"}).code, ExitCode::Done);
}

TEST(Constants, AreNotSetForAChartAloneWhichReadsNone) {
    const Folder folder;
    const std::string file = folder.write("tank.grafcet", tank);
    for (const char* verb : {"check", "nusmv", "aiger", "btor2", "simulate", "report"}) {
        const Result result = grafverif({verb, file, "--chart", "filling", "--set", "N=3"});
        EXPECT_EQ(result.code, ExitCode::Input) << verb;
        EXPECT_NE(result.err.find("selects a chart without its closed loop"), std::string::npos) << verb << result.err;
        EXPECT_TRUE(result.out.empty()) << verb;
    }
    // `mutate` checks the mutants of the chart in its loop, which declares N.
    EXPECT_NE(grafverif({"mutate", file, "--chart", "filling", "--limit", "1", "--set", "N=3"}).code, ExitCode::Input);
}

TEST(Constants, SetForMutantsAreSetInEachSeparately) {
    const Folder folder;
    const std::string file = folder.write("tank.grafcet", tank), state = folder.file("state");
    const auto lines = [&](const std::string& n) {
        EXPECT_NE(grafverif({"mutate", file, "--limit", "3", "--set", n, "--state", state}).code, ExitCode::Input);
        const std::string text = folder.read("state");
        return std::ranges::count(text, '{');
    };
    const auto first = lines("N=1");
    EXPECT_GT(first, 0);
    EXPECT_EQ(lines("N=1"), first);
    EXPECT_EQ(lines("N=3"), 2 * first);
}

TEST(Constants, KeepTheirPlaceInTheLayout) {
    const Folder folder;
    const Result result = grafverif({"fmt", folder.write("tank.grafcet", tank)});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    EXPECT_NE(result.out.find("    constant N: int 1..8 = 2, UNIT = 1s;\n    constant TWICE = 2 * N;\n"),
              std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("valve(ORDER = COARSE || FINE, FLOW = FLOW, TRAVEL = N * UNIT);"), std::string::npos)
        << result.out;
}

}  // namespace
}  // namespace grafverif::app
