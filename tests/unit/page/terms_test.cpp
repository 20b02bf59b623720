// SPDX-License-Identifier: MIT
#include "page/terms.hpp"

#include "content.hpp"

namespace grafverif {
namespace {

using Json = nlohmann::ordered_json;

const Json& node(const Json& chart, const Json& place) { return chart["terms"][place.get<std::size_t>()]; }

TEST(Terms, OfAConditionUnfoldIntoLeavesWithTheirPlaces) {
    const ParseResult reading = read_string(press, "test.grafcet");
    const Json chart = chart_json(reading.model->charts[{0}]);
    const Json& t1 = node(chart, chart["transitions"][1]["condition"]);
    EXPECT_EQ(t1["op"], "and");
    EXPECT_EQ(t1["text"], "2s/X1 && (DONE || START)");
    const Json &timed = node(chart, t1["args"][0]), &either = node(chart, t1["args"][1]);
    EXPECT_EQ(timed["op"], "timed");
    EXPECT_EQ(timed["text"], "2s/X1");
    EXPECT_EQ(chart["timed"][timed["place"].get<std::size_t>()]["rise"], 2000);
    EXPECT_EQ(either["op"], "or");
    EXPECT_EQ(node(chart, either["args"][0])["text"], "DONE");
    EXPECT_EQ(node(chart, either["args"][0])["place"], 1) << "among the inputs";
    const Json& t0 = node(chart, chart["transitions"][0]["condition"]);
    EXPECT_EQ(t0["op"], "rise");
    EXPECT_EQ(node(chart, t0["args"][0])["op"], "input");
}

TEST(Terms, OfAChartRequireTheExitStepAfterAMacroStep) {
    const ParseResult reading = read_string(R"(
grafcet line {
    input A, B;
    initial step 0;
    macro step M1 expands cycle;
    transition t0: 0 -> M1 when A;
    transition t1: M1 -> 0 when B;
    expansion cycle {
        entry step E;
        exit step S;
        transition c0: E -> S when true;
    }
}
)",
                                            "test.grafcet");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    const Json chart = chart_json(reading.model->charts[{0}]);
    std::vector<std::string> from;
    for (const Json& step : chart["transitions"][1]["from"]) from.push_back(chart["steps"][step.get<std::size_t>()]);
    EXPECT_EQ(from, (std::vector<std::string>{"XM1", "cycle.XS"}));
}

TEST(Terms, ClaimsAreThoseOfTheFile) {
    const ParseResult reading = read_string(R"(
grafcet lamp {
    input ON;
    output LAMP;
    initial step 0 { LAMP; }
    transition t0: 0 -> 0 when 3s/X0 && ON;
}
closed_loop room {
    controller lamp;
    environment Button = free(OUT = ON);
    property p "either: or; not" expected violated: always ON  =>
        // in any case
        LAMP /* also
        here */ at stable;
    property q: never !ON || 3s/X0 || LAMP;
    property all: reachable all steps;
}
)",
                                            "test.grafcet");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    const auto claim = [&](const std::string& name) {
        return expectation_text(*reading.model, Id<ClosedLoop>{0}, name, reading.sources);
    };
    EXPECT_EQ(claim("p"), "always ON => LAMP at stable");
    EXPECT_EQ(claim("q"), "never !ON || 3s/X0 || LAMP");
    EXPECT_EQ(claim("all.X0"), "reachable all steps");
    EXPECT_EQ(claim("no_race"), "");
    const Sources none;
    EXPECT_EQ(expectation_text(*reading.model, Id<ClosedLoop>{0}, "p", none), "always !ON || LAMP at stable");
}

TEST(Terms, FollowTheirOperands) {
    const ParseResult reading = read_string(press, "test.grafcet");
    const Json chart = chart_json(reading.model->charts[{0}]);
    for (std::size_t k = 0; k < chart["terms"].size(); ++k)
        for (const Json& operand : chart["terms"][k].value("args", Json::array()))
            EXPECT_LT(operand.get<std::size_t>(), k);
}

TEST(Terms, OfAPropertyNameTheControllerOrThePlant) {
    const std::string text = press + R"(
closed_loop moving {
    controller press;
    environment Start = free(OUT = START);
    environment Done = free(OUT = DONE);
    plant Arm = cylinder_5_3(G_IN = DONE, G_OUT = MOTOR, X = PLACE, X_max = 4);
    property p: never MOTOR && PLACE >= 2 && Arm.still && X1;
}
)";
    const ParseResult reading = read_string(text, "test.grafcet");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    const ClosedLoop& loop = reading.model->loops[{1}];
    const Json property = property_json(*reading.model, loop, loop.properties[{0}]);
    EXPECT_EQ(property["pattern"], "never");
    const Json& all = node(property, property["operands"][0]);
    ASSERT_EQ(all["args"].size(), 4U);
    EXPECT_EQ(node(property, all["args"][0])["op"], "output");
    EXPECT_EQ(node(property, all["args"][0])["controller"], 0);
    const Json& comparison = node(property, all["args"][1]);
    EXPECT_EQ(comparison["op"], "greater-equal");
    EXPECT_EQ(node(property, comparison["args"][0])["op"], "signal");
    EXPECT_EQ(node(property, comparison["args"][1])["value"], 2);
    EXPECT_EQ(node(property, all["args"][2])["location"], "still");
    EXPECT_EQ(node(property, all["args"][3])["op"], "step");
}

TEST(Terms, ReplaceAContinuousOutputByItsActions) {
    const ParseResult reading = read_string(R"(
grafcet two {
    input A;
    output LAMP, OTHER;
    initial step 0 { LAMP if A; OTHER; }
    step 1 { LAMP; }
    transition t0: 0 -> 1 when A;
    transition t1: 1 -> 0 when LAMP && !A;
}
)",
                                            "test.grafcet");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    const Json chart = chart_json(reading.model->charts[{0}]);
    const Json& both = node(chart, chart["transitions"][1]["condition"]);
    const Json& lamp = node(chart, both["args"][0]);
    EXPECT_EQ(lamp["op"], "output");
    EXPECT_EQ(lamp["stored"], false);
    ASSERT_EQ(lamp["actions"].size(), 2U);
    EXPECT_EQ(lamp["actions"][0]["step"], 0);
    EXPECT_EQ(node(chart, lamp["actions"][0]["condition"])["text"], "A");
}

}  // namespace
}  // namespace grafverif
