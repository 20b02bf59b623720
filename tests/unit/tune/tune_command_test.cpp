// SPDX-License-Identifier: MIT
// Tests `grafverif tune`: text, JSON, exit codes and invalid values.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "unit/app/run_program.hpp"

namespace grafverif::app {
namespace {

const std::string text =
    "grafcet press {\n    input START, DONE;\n    output DOWN;\n\n    initial step 0;\n    step 1 { DOWN; }\n\n"
    "    transition t0: 0 -> 1 when START;\n    transition t1: 1 -> 0 when 5s/X1;\n}\n\n"
    "component ram(input G; output OUT; HIGH = 3s) {\n    clock t;\n\n    initial location up;\n"
    "    location moving invariant t <= HIGH;\n    location down with OUT := true;\n\n"
    "    urgent up -> moving when G do t := 0;\n    timed moving -> down when t >= 1s do OUT := true;\n"
    "    urgent down -> up when !G do OUT := false;\n}\n\n"
    "closed_loop station {\n    controller press;\n    constant HIGH = 3s, GAP = 1s, N = 4, LAMP = true;\n\n"
    "    environment Start = push_button(OUT = START, GAP = GAP);\n"
    "    plant Ram = ram(G = DOWN, OUT = DONE, HIGH = HIGH);\n\n"
    "    property soon \"the ram arrives\": DOWN leads to DONE within 6s;\n    property few: never N > 6;\n}\n";

class TuneCommand : public testing::Test {
protected:
    Result tune(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"tune", file_});
        return grafverif(arguments);
    }
    void expect_error(std::vector<std::string> arguments, const std::string& message) const {
        const Result result = tune(std::move(arguments));
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    }

    Folder folder_ = {};
    std::string file_ = folder_.write("station.grafcet", text);
};

TEST_F(TuneCommand, PrintsIntervalsAndMargins) {
    const Result result = tune({"--over", "HIGH=1s..9s", "--jobs", "1"});
    EXPECT_EQ(result.code, ExitCode::Verdict);
    EXPECT_NE(result.out.find("HIGH = 1s..9s in steps of 1s; current value 3s\n"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("soon \"the ram arrives\": holds at 6 of 9 points\n"
                              "    HIGH    verdict\n"
                              "    1s..6s  holds\n"
                              "    7s..9s  violated\n"
                              "    violated at HIGH = 7s, 4s above the current value 3s\n"),
              std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("few: holds at all 9 points\n"), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find("no_timelock"), std::string::npos) << result.out;
}

TEST_F(TuneCommand, PrintsAMapOfTwoConstants) {
    const Result result = tune({"--over", "GAP=1s..2s", "--over", "HIGH=3s..7s:2s", "--property", "soon"});
    EXPECT_NE(result.out.find("    GAP  HIGH = 3s..7s\n"
                              "     1s [+]+ -\n"
                              "     2s  + + -\n"),
              std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("+ holds, - violated, ? unknown"), std::string::npos);
}

TEST_F(TuneCommand, WritesAnHtmlReportWithTheVerdictsOfTheText) {
    const std::string page = folder_.file("map.html");
    const std::vector<std::string> over = {"--over", "GAP=1s..2s", "--over", "HIGH=3s..7s:2s"};
    std::vector<std::string> with_page = over;
    with_page.insert(with_page.end(), {"--report", page});
    const Result result = tune(with_page);
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
    EXPECT_EQ(result.out, tune(over).out);
    const std::string html = folder_.read("map.html");
    EXPECT_NE(html.find("1 property has an unexpected verdict at some grid point."), std::string::npos);
    EXPECT_NE(html.find("holds at 4, violated at 2 of 6 points"), std::string::npos);
    for (const char* const gap : {"1s", "2s"})
        EXPECT_NE(html.find("data-run=\"soon: GAP = " + std::string(gap) + ", HIGH = 7s\""), std::string::npos) << gap;
    EXPECT_NE(html.find("violated at HIGH = 7s, 4s above the current value 3s"), std::string::npos);
}

TEST_F(TuneCommand, ExitCodeIsZeroIfEachVerdictIsExpected) {
    const Result result = tune({"--over", "N=1..6", "--over", "HIGH=1s..5s"});
    EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
}

TEST_F(TuneCommand, JsonContainsBoxesAndMargins) {
    const auto json = nlohmann::json::parse(tune({"--over", "HIGH=1s..9s", "--format", "json"}).out);
    EXPECT_EQ(json["constants"],
              nlohmann::json::parse(R"([{"name":"HIGH","low":"1s","high":"9s","step":"1s","current":"3s"}])"));
    EXPECT_EQ(json["points"], 9);
    EXPECT_LT(json["checks"], 9);
    const auto& soon = json["properties"][0];
    EXPECT_EQ(soon["name"], "soon");
    EXPECT_EQ(soon["line"], 31);
    EXPECT_EQ(soon["boxes"], nlohmann::json::parse(
                                 R"([{"constants":{"HIGH":["1s","6s"]},"points":6,"verdict":"holds","reason":null},
                      {"constants":{"HIGH":["7s","9s"]},"points":3,"verdict":"violated","reason":null}])"));
    EXPECT_EQ(soon["margins"], nlohmann::json::parse(
                                   R"([{"constant":"HIGH","direction":"up","value":"7s","distance":"4s",
                                        "verdict":"violated"}])"));
}

TEST_F(TuneCommand, WritesToAFile) {
    const Result result = tune({"--over", "N=1..8", "--format", "json", "-o", folder_.file("n.json")});
    EXPECT_EQ(result.code, ExitCode::Verdict);
    EXPECT_EQ(nlohmann::json::parse(folder_.read("n.json"))["properties"][1]["boxes"].size(), 2U);
}

TEST_F(TuneCommand, InvalidValuesAreRejected) {
    expect_error({}, "`tune` needs the values of at least one constant; pass `--over`");
    for (const char* const each : {"HIGH", "HIGH=3s", "=1..2", "HIGH=..3s", "HIGH=1s..", "HIGH=1s..3s:"})
        expect_error({"--over", each}, "invalid value `" + std::string(each) + "` of `--over`; name a constant");
    expect_error({"--over", "HIG=1s..3s"}, "has no constant `HIG`; did you mean `HIGH`?");
    expect_error({"--over", "HIGH=1..3"},
                 "the constant `HIGH` is a duration and cannot have the values `1..3`; write `--over HIGH=1s..20s:1s`");
    expect_error({"--over", "N=1s..3s"}, "the constant `N` is an integer and cannot have the values `1s..3s`");
    expect_error({"--over", "LAMP=0..1"}, "the constant `LAMP` is Boolean; `--over` accepts only numbers");
    expect_error({"--over", "HIGH=9s..3s"}, "the range `9s..3s` of `HIGH` is empty; write the smaller value first");
    expect_error({"--over", "N=1..6:2"},
                 "the step 2 does not divide the range `1..6` of `N`; end the range at 5, or change the step");
    expect_error({"--over", "N=1..6:0"}, "the step of `N` is 0; use a positive step");
    expect_error({"--over", "HIGH=1s..2s", "--over", "HIGH=1s..3s"}, "`--over` names `HIGH` twice; remove one");
    expect_error({"--over", "HIGH=1s..2s", "--set", "HIGH=3s"}, "`--set` and `--over` both name `HIGH`; remove one");
    expect_error({"--over", "GAP=1s..1000s", "--over", "HIGH=1s..1000000s"},
                 "the grid has 1000000000 points, but at most 10000 are allowed; at one millisecond per point, reading "
                 "the models of all points would take 277.8 hours; use larger steps or smaller ranges");
    expect_error({"--over", "N=-5000000000000000000..5000000000000000000:1000000000000000000"},
                 "of `N` are outside the integer range -32768..32767; reduce the range");
    expect_error({"--over", "N=1..3", "--property", "son"}, "soon");
}

TEST_F(TuneCommand, AllErrorsAreReportedInOneRun) {
    const Result result = tune({"--over", "N=3..1", "--over", "HIG=1s..3s", "--over", "GAP"});
    for (const char* const part : {"of `N` is empty", "did you mean `HIGH`?", "invalid value `GAP`"})
        EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("station.grafcet:26:35: error: the range `3..1` of `N` is empty"), std::string::npos)
        << result.err;
}

TEST_F(TuneCommand, ReportsWhatIsDecidedAtTheTimeLimit) {
    const Result result = tune({"--over", "N=1..100", "--over", "HIGH=1s..100s", "--every-point", "--timeout", "1s"});
    EXPECT_EQ(result.code == ExitCode::Unknown || result.code == ExitCode::Verdict, true);
    EXPECT_NE(result.out.find("stopped at the time limit of 1 s; raise `--timeout`"), std::string::npos)
        << result.out.substr(0, 500);
}

}  // namespace
}  // namespace grafverif::app
