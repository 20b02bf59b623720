// SPDX-License-Identifier: MIT
#include "report/json.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "traces.hpp"

namespace grafverif {
namespace {

using Json = nlohmann::ordered_json;

Json json(const Report& report) {
    std::ostringstream out;
    print_json(report, Sources{}, out);
    return Json::parse(out.str());
}

std::vector<std::string> keys(const Json& object) {
    std::vector<std::string> names;
    for (const auto& [key, value] : object.items()) names.push_back(key);
    return names;
}

TEST(Json, HasTheDocumentedKeys) {
    const Json document = json(sample_report());
    EXPECT_EQ(keys(document), (std::vector<std::string>{"model", "properties"}));
    ASSERT_EQ(document["properties"].size(), 6u);
    for (const Json& property : document["properties"])
        EXPECT_EQ(keys(property),
                  (std::vector<std::string>{"name",    "text",     "file",        "line",       "column",
                                            "verdict", "expected", "declared",    "engine",     "mode",
                                            "grain",   "states",   "transitions", "seconds",    "reason",
                                            "vacuous", "notes",    "assumptions", "trace_text", "trace"}));
    const Json& trace = document["properties"][1]["trace"];
    EXPECT_EQ(keys(trace), (std::vector<std::string>{"loop_from", "steps", "run"}));
    for (const Json& step : trace["steps"])
        EXPECT_EQ(keys(step), (std::vector<std::string>{"time", "kind", "component", "inputs", "fired", "situation",
                                                        "outputs", "moment"}));
    EXPECT_EQ(keys(trace["run"]),
              (std::vector<std::string>{"version", "name", "timed", "controllers", "steps", "transitions", "timers",
                                        "signals", "instances", "moments", "loop"}));
}

TEST(Json, HasTheMomentsThatTheStepsSummarize) {
    const Json trace = json(sample_report())["properties"][1]["trace"];
    const Json& run = trace["run"];
    EXPECT_EQ(run["version"], 1);
    EXPECT_EQ(run["steps"][2], (Json{{"name", "G2.2"}, {"full_name", "G2.2"}, {"short_name", "2"}}));
    EXPECT_EQ(run["transitions"][1], Json::object({{"name", "t2"}}));
    EXPECT_EQ(run["signals"][1], (Json{{"name", "GO"}, {"role", "output"}}));
    EXPECT_EQ(run["signals"][4], (Json{{"name", "COUNT"}, {"role", "internal"}, {"range", {-4, 4}}}));
    EXPECT_EQ(run["loop"], 3);
    // Values that a row does not list are unchanged.
    std::map<int, int> values;
    Json situation;
    std::size_t reported = 0;
    for (std::size_t moment = 0; moment < run["moments"].size(); ++moment) {
        const Json& now = run["moments"][moment];
        for (const Json& value : now["values"]) values[value[0]] = value[1];
        if (now.contains("situation")) situation = now["situation"];
        const Json& step = trace["steps"][reported];
        if (step["moment"] != moment) continue;
        EXPECT_EQ(step["time"], now["time"]);
        for (std::size_t signal = 0; signal < run["signals"].size(); ++signal) {
            if (run["signals"][signal]["role"] != "output") continue;
            const std::string name = run["signals"][signal]["name"];
            EXPECT_EQ(step["outputs"][name], values[static_cast<int>(signal)] != 0) << name;
        }
        for (std::size_t i = 0; i < situation.size(); ++i)
            EXPECT_EQ(step["situation"][i], run["steps"][situation[i].get<std::size_t>()]["full_name"]);
        ++reported;
    }
    EXPECT_EQ(reported, trace["steps"].size());
}

TEST(Json, GivesVerdictsAsTheyAre) {
    const Json properties = json(sample_report())["properties"];
    EXPECT_EQ(properties[0]["verdict"], "holds");
    EXPECT_EQ(properties[0]["trace"], nullptr);
    EXPECT_EQ(properties[0]["reason"], nullptr);
    EXPECT_EQ(properties[1]["text"], "a <dangerous> & \"quoted\" text");
    EXPECT_EQ(properties[2]["verdict"], "unknown");
    EXPECT_EQ(properties[2]["text"], nullptr);
    EXPECT_EQ(properties[2]["reason"], "12 states are not enough");
    EXPECT_EQ(properties[4]["expected"], "violated");
    EXPECT_EQ(properties[5]["vacuous"], true);
    EXPECT_EQ(properties[5]["notes"][0], "time never passes");
}

TEST(Json, GivesAllInputsAndOutputsInEveryStep) {
    const Json trace = json(sample_report())["properties"][1]["trace"];
    EXPECT_EQ(trace["loop_from"], 3);
    const Json& cleared = trace["steps"][2];
    EXPECT_EQ(cleared["time"], 0);
    EXPECT_EQ(cleared["kind"], "controller");
    EXPECT_EQ(cleared["component"], "press");
    EXPECT_EQ(cleared["inputs"], (Json{{"START", true}, {"LEVEL", 2}}));
    EXPECT_EQ(cleared["fired"], (Json{"t1", "t2", "t3"}));
    EXPECT_EQ(cleared["situation"], (Json{"1", "G2.2"}));
    EXPECT_EQ(cleared["outputs"], (Json{{"GO", true}, {"IDLE", false}}));
    EXPECT_EQ(trace["steps"][3]["time"], 1500);
    EXPECT_EQ(trace["steps"][3]["component"], nullptr);
}

TEST(Json, ListsModelErrors) {
    Report report = sample_report();
    report.error_traces = {{"action-race", "two actions race", sample_run()}};
    const Json errors = json(report)["errors"];
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(keys(errors[0]), (std::vector<std::string>{"code", "message", "trace_text", "trace"}));
}

TEST(Json, AcceptsTextThatIsNotUtf8) {
    Report report = sample_report();
    report.answers[0].text = "caf\xE9";
    EXPECT_EQ(json(report)["properties"][0]["text"], "caf\uFFFD");
}

}  // namespace
}  // namespace grafverif
