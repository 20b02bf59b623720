// SPDX-License-Identifier: MIT
// `supervise`: conditions on charts, the text with them, and what is said where there are none.
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
        EXPECT_TRUE(says(again.out, "nothing need be forbidden")) << again.out << again.err;
    }
}

TEST(Supervise, WhatNoControllerPreventsIsToldAsARun) {
    const Folder folder;
    const std::string text =
        changed(crossing_text(), "urgent home -> out when GO && !BACK", "timed home -> out when true");
    const Result none = grafverif({"supervise", folder.write("rolls.grafcet", text)});
    EXPECT_EQ(none.code, ExitCode::Verdict) << none.err;
    EXPECT_TRUE(says(none.out, "There are no such conditions: whatever the chart forbids, the plant can break"))
        << none.out;
    EXPECT_TRUE(says(none.out, "Cart_1: out")) << none.out;
    EXPECT_FALSE(says(none.out, "may_")) << none.out;
}

TEST(Supervise, JsonSaysAllOfIt) {
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

TEST(Supervise, AMarkedTermStaysWithinReach) {
    const Result made = grafverif({"supervise", crossing, "--marked", "second.X2 && HOME_1"});
    EXPECT_EQ(made.code, ExitCode::Done) << made.err;
    EXPECT_TRUE(says(made.out, "to stay within reach: second.X2 && HOME_1")) << made.out;
    const Result never = grafverif({"supervise", crossing, "--marked", "!HOME_1 && !HOME_2"});
    EXPECT_EQ(never.code, ExitCode::Verdict) << never.err;
    EXPECT_TRUE(says(never.out, "the plant can come to where nothing marked can be")) << never.out;
}

TEST(Supervise, BadInputIsRefusedWithAdvice) {
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
}

}  // namespace
}  // namespace grafverif::app
