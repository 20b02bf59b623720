// SPDX-License-Identifier: MIT
// Tests `supervise`: the conditions on charts, the text that contains them, and the messages if there are none.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "grafverif/grafverif.hpp"
#include "run_program.hpp"

namespace grafverif::app {
namespace {

const std::string crossing = (root / "docs/crossing.grafcet").string();

std::string changed(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

std::string crossing_text() { return read_file(crossing).sources.begin()->text; }

bool says(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

TEST(Supervise, TheTextWithTheConditionsIsCanonicalAndItsPropertiesHold) {
    const Folder folder;
    const std::string safe = folder.file("safe.grafcet");
    EXPECT_EQ(grafverif({"check", crossing}).code, ExitCode::Verdict);
    for (const char* held : {"both", "transitions"}) {
        const Result made = grafverif({"supervise", crossing, "--conditions", held, "-o", safe});
        ASSERT_EQ(made.code, ExitCode::Done) << made.err;
        EXPECT_TRUE(says(made.out, "Added to the conditions of the chart:")) << made.out;
        EXPECT_EQ(grafverif({"fmt", "--check", safe}).code, ExitCode::Done);
        EXPECT_EQ(grafverif({"check", safe, "--grain", "atomic"}).code, ExitCode::Done);
        const Result again = grafverif({"supervise", safe});
        EXPECT_TRUE(says(again.out, "to enforce hold without conditions")) << again.out << again.err;
    }
}

TEST(Supervise, UnavoidableViolationIsShownAsARun) {
    const Folder folder;
    const std::string text =
        changed(crossing_text(), "urgent home -> out when GO && !BACK", "timed home -> out when true");
    const Result none = grafverif({"supervise", folder.write("rolls.grafcet", text)});
    EXPECT_EQ(none.code, ExitCode::Verdict) << none.err;
    EXPECT_TRUE(says(none.out, "No such conditions exist: for all conditions on the chart, the plant can violate"))
        << none.out;
    EXPECT_TRUE(says(none.out, "Cart_1: out")) << none.out;
    EXPECT_FALSE(says(none.out, "may_")) << none.out;
}

TEST(Supervise, JsonIsComplete) {
    const Result made = grafverif({"supervise", crossing, "--conditions", "transitions", "--format", "json"});
    ASSERT_EQ(made.code, ExitCode::Done) << made.err;
    const auto json = nlohmann::json::parse(made.out);
    EXPECT_EQ(json["outcome"], "found");
    EXPECT_EQ(json["claim"], "one of several");
    EXPECT_EQ(json["no_timelock"], "holds");
    EXPECT_EQ(json["kept"], nlohmann::json::array({"alone"}));
    ASSERT_EQ(json["conditions"].size(), 2U);
    EXPECT_EQ(json["conditions"][0]["transition"], "leave_1");
    EXPECT_TRUE(says(json["conditions"][0]["place"], "crossing.grafcet:15"));
}

TEST(Supervise, MarkedTermStaysReachable) {
    const Result made = grafverif({"supervise", crossing, "--marked", "second.X2 && HOME_1"});
    EXPECT_EQ(made.code, ExitCode::Done) << made.err;
    EXPECT_TRUE(says(made.out, "to keep reachable: second.X2 && HOME_1")) << made.out;
    const Result never = grafverif({"supervise", crossing, "--marked", "!HOME_1 && !HOME_2"});
    EXPECT_EQ(never.code, ExitCode::Verdict) << never.err;
    EXPECT_TRUE(says(never.out, "the plant can reach a state from which no marked state")) << never.out;
}

const std::string heater =
    "grafcet c {\n    input a, b;\n    output o1;\n    initial step 0 { o1 if a && b; }\n    step 1 { o1; }\n"
    "    initial step 5 { o1 if !a; }\n    transition t0: 5 -> 1 when a;\n    transition t1: 1 -> 5 when !a;\n}\n"
    "component oven(input ON; output HOT) {\n    initial location idle;\n    location hot;\n    location burnt;\n"
    "    timed idle -> hot when !ON do HOT := true;\n    timed hot -> idle when true do HOT := false;\n"
    "    timed hot -> burnt when ON;\n}\n"
    "component never_on(output B) {\n    initial location off;\n    location on;\n"
    "    urgent on -> off when true do B := true;\n}\n"
    "closed_loop l {\n    controller c with stability_search;\n    plant Oven = oven(ON = o1, HOT = a);\n"
    "    plant Switch = never_on(B = b);\n    property safe: never Oven in burnt;\n"
    "    property cools: inevitable b;\n    property burns expected violated: never X1;\n}\n";

TEST(Supervise, ReportsActionsThatConditionsDisable) {
    const Folder folder;
    const Result made = grafverif({"supervise", folder.write("heater.grafcet", heater)});
    ASSERT_EQ(made.code, ExitCode::Done) << made.out << made.err;
    EXPECT_TRUE(says(made.out, "output o1 in X1  && false, so this action never sets the output\n")) << made.out;
    EXPECT_FALSE(says(made.out, "output o1 in X0")) << made.out;  // b is never true, so step 0 never sets o1
    const Result possible =
        grafverif({"supervise", folder.write("other.grafcet", changed(heater, "o1 if a && b", "o1 if a && !b"))});
    ASSERT_EQ(possible.code, ExitCode::Done) << possible.out << possible.err;
    EXPECT_TRUE(says(possible.out, "output o1 in X0")) << possible.out;
}

TEST(Supervise, PropertiesThatItDoesNotConsiderAreNamed) {
    const Folder folder;
    const std::string file = folder.write("heater.grafcet", heater);
    const Result made = grafverif({"supervise", file});
    EXPECT_TRUE(says(made.out, "ignored, not a property of all states: cools\n")) << made.out;
    EXPECT_TRUE(says(made.out, "ignored, expected violated: burns\n")) << made.out;
    const std::string cold = changed(heater, "timed hot -> burnt when ON", "timed burnt -> idle when ON");
    const std::string safe =
        folder.write("safe.grafcet", changed(cold, "safe: never Oven in burnt", "safe: never X1 && X5"));
    const Result holds = grafverif({"supervise", safe});
    EXPECT_EQ(holds.code, ExitCode::Done) << holds.out << holds.err;
    EXPECT_TRUE(says(holds.out, "The properties to enforce hold without conditions")) << holds.out;
    EXPECT_TRUE(says(holds.out, "ignored, not a property of all states: cools\n")) << holds.out;
    for (const std::string chosen : {"", "safe"}) {
        std::vector<std::string> words{"supervise", file, "--format", "json"};
        if (!chosen.empty()) words.insert(words.end(), {"--property", chosen});
        const Result json = grafverif(words);
        const auto ignored = nlohmann::json::parse(json.out)["ignored"];
        ASSERT_EQ(ignored.size(), 2U) << json.out;
        EXPECT_EQ(ignored[0]["property"], "cools");
        EXPECT_EQ(ignored[0]["reason"], chosen.empty() ? "not a property of all states" : "not selected");
    }
}

const std::string bridge =
    R"(// Traffic lights of a bridge with one lane. After each green phase, both directions are red for 5 s.
grafcet lights {
    output EAST, WEST;

    initial step 0 { EAST; }
    step 1;
    step 2 { WEST; }
    step 3;

    transition t0: 0 -> 1 when 10s/X0;
    transition t1: 1 -> 2 when 5s/X1;
    transition t2: 2 -> 3 when 10s/X2;
    transition t3: 3 -> 0 when 5s/X3;
}

// Cars of one direction: they enter while it is green, and cross in at most CROSS.
component cars(input GREEN; output ON_BRIDGE; CROSS = 4s) {
    clock t;

    initial location none;
    location crossing invariant t <= CROSS with ON_BRIDGE := true;

    timed none -> crossing when GREEN do ON_BRIDGE := true, t := 0;
    timed crossing -> none when true do ON_BRIDGE := false;
}

closed_loop bridge {
    controller lights;

    plant East = cars(GREEN = EAST, ON_BRIDGE = EAST_CAR);
    plant West = cars(GREEN = WEST, ON_BRIDGE = WEST_CAR);

    property alone "cars of one direction only are on the bridge": never EAST_CAR && WEST_CAR;
    property lively "each direction gets green again": EAST at least every 30s;
}
)";

TEST(Supervise, PropertyThatNeedsDurationsIsNamedInsteadOfADisablingCondition) {
    const Folder folder;
    const std::string file = folder.write("bridge.grafcet", bridge), safe = folder.file("safe.grafcet");
    const Result made = grafverif({"supervise", file, "-o", safe});
    EXPECT_EQ(made.code, ExitCode::Verdict) << made.out << made.err;
    EXPECT_FALSE(says(made.out, "&& false")) << made.out;
    EXPECT_TRUE(says(made.out, "disable parts of the chart")) << made.out;
    EXPECT_TRUE(
        says(made.out, "alone holds without conditions: it depends on durations, which the untimed model omits"))
        << made.out;
    EXPECT_TRUE(says(made.out, "ignored, with a duration, which the untimed model omits: lively\n")) << made.out;
    EXPECT_FALSE(fs::exists(safe));
    const auto json = nlohmann::json::parse(grafverif({"supervise", file, "--format", "json"}).out);
    EXPECT_EQ(json["outcome"], "disabling");
    EXPECT_EQ(json["disabled_outputs"], (nlohmann::json{"EAST", "WEST"}));
    EXPECT_EQ(json["timed"], nlohmann::json::array({{{"property", "alone"}, {"verdict", "holds"}}}));
}

TEST(Supervise, DisablingConditionsOfAPropertyThatFailsInTheTimedLoopAreReported) {
    const Folder folder;
    const Result made =
        grafverif({"supervise", folder.write("bridge.grafcet", changed(bridge, "CROSS = 4s", "CROSS = 8s"))});
    EXPECT_EQ(made.code, ExitCode::Verdict) << made.out << made.err;
    EXPECT_TRUE(says(made.out, "disable parts of the chart")) << made.out;
    EXPECT_TRUE(says(made.out, "alone is violated without conditions")) << made.out;
    EXPECT_FALSE(says(made.out, "depends on durations")) << made.out;
}

TEST(Supervise, StepsThatTheConditionsMakeUnreachableAreNamed) {
    const Folder folder;
    std::string text = changed(crossing_text(), "transition return_1: 2 -> 0 when HOME_1;",
                               "transition return_1: 2 -> 0 when HOME_1;\n"
                               "        transition crash: 1 -> 9 when !HOME_1 && !HOME_2;");
    text = changed(text, "step 2 { BACK_1; }", "step 2 { BACK_1; }\n        step 9;");
    const Result made = grafverif({"supervise", folder.write("crash.grafcet", text)});
    EXPECT_EQ(made.code, ExitCode::Done) << made.out << made.err;
    EXPECT_TRUE(says(made.out, "active without the conditions, but are never active with the conditions: first.X9"))
        << made.out;
}

TEST(Supervise, BadInputIsRejectedWithAdvice) {
    struct Case {
        std::vector<std::string> arguments = {};
        std::string says = {};
    };
    for (const Case& one : {Case{{"--property", "alon"}, "did you mean `alone`?"}, Case{{"--marked", "X9"}, "unknown"},
                            Case{{"--marked", "HOME_1; property p: never HOME_1"}, "one term"},
                            Case{{"--marked", "HOME_1 &&"}, "--marked"},
                            Case{{"--conditions", "all"}, "`both`, `transitions`, `outputs`"}}) {
        std::vector<std::string> arguments{"supervise", crossing};
        arguments.insert(arguments.end(), one.arguments.begin(), one.arguments.end());
        const Result refused = grafverif(arguments);
        EXPECT_EQ(refused.code, ExitCode::Input) << one.says;
        EXPECT_TRUE(says(refused.err, one.says)) << refused.err;
    }
    const Result stopped = grafverif({"supervise", crossing, "--timeout", "0s"});
    EXPECT_EQ(stopped.code, ExitCode::Unknown) << stopped.out << stopped.err;
    EXPECT_TRUE(says(stopped.out, "unknown: stopped at the time limit of 0 s; raise `--timeout`")) << stopped.out;
}

TEST(Supervise, RejectsTransitionsAndActionsInsideFor) {
    const Folder folder;
    for (const char* copies : {"1..1", "1..2"}) {
        SCOPED_TRACE(copies);
        const std::string name = std::string(copies) == "1..1" ? "one" : "two";
        for (const char* element : {"transition t[i]: 0 -> s[i] when GO; transition s[i] -> 0 when !GO; step s[i];",
                                    "partial p[i] { initial step 0 { LAMP[i]; } }"}) {
            const std::string text = std::string("grafcet lamps {\n    input GO;\n    initial step 0;\n    for i in ") +
                                     copies + " { output LAMP[i]; " + element +
                                     " }\n}\nclosed_loop l { controller lamps; environment Go = free(OUT = GO); "
                                     "property p: never LAMP[1]; }\n";
            const Result refused = grafverif({"supervise", folder.write(name + ".grafcet", text)});
            EXPECT_EQ(refused.code, ExitCode::Input) << refused.out << refused.err;
            EXPECT_TRUE(
                says(refused.err, "a replicated declaration or a chart instance in `supervise` is not supported"))
                << refused.err;
        }
    }
}

}  // namespace
}  // namespace grafverif::app
