// SPDX-License-Identifier: MIT
// Tests findings as text, JSON and SARIF, and the table of exclusions.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "analyse/analyse.hpp"
#include "derive/derive.hpp"
#include "read/exclusions.hpp"
#include "read/text.hpp"
#include "report/findings.hpp"
#include "report/sarif.hpp"

namespace grafverif {
namespace {

constexpr std::string_view two_buttons = R"(grafcet two_buttons {
    input  a, b, spare;
    output O;
    accept input-never-read spare "later";
    initial step 0;
    step 1 { O; }
    step 2;
    transition t0: 0 -> 1 when a;
    transition t1: 0 -> 2 when b;
    transition t2: 1 -> 0 when !a && !b;
    transition t3: 2 -> 0 when !a && !b;
}
)";

struct Analysed {
    Sources sources = {};
    Chart chart = {};
    Analysis analysis = {};
};

Analysed analysed(std::string text) {
    Analysed made;
    Diagnostics diagnostics;
    const std::vector<LibraryEntry> library;
    const ReadContext context{[](const std::string&, std::string&) -> std::optional<std::string> { return {}; },
                              library};
    const auto model =
        read_text(made.sources.add({"two buttons.grafcet", std::move(text)}), made.sources, context, diagnostics);
    std::ostringstream rendered;
    render_text(diagnostics.all(), made.sources, Colour::Plain, rendered);
    if (!model) throw std::invalid_argument(rendered.str());
    made.chart = *model->charts.begin();
    made.analysis = analyse(made.chart, derive(made.chart, diagnostics).value());
    return made;
}

TEST(Findings, AsTextHaveLocationRunAndAcceptedFindings) {
    const Analysed made = analysed(std::string(two_buttons));
    std::ostringstream out;
    print_findings(made.analysis, made.sources, Colour::Plain, out);
    EXPECT_NE(out.str().find("two buttons.grafcet:9:5: warning: `t0` and `t1` leave the same step"), std::string::npos)
        << out.str();
    EXPECT_NE(out.str().find("shortest trace: both transitions are cleared in the last instant"), std::string::npos)
        << out.str();
    EXPECT_NE(out.str().find("accepted: the chart does not depend on the input `spare` [input-never-read]: later"),
              std::string::npos);
    EXPECT_NE(out.str().find("two_buttons: 1 warning, 1 accepted"), std::string::npos) << out.str();
}

TEST(Findings, AsJsonHaveAllTheirParts) {
    const Analysed made = analysed(std::string(two_buttons));
    std::ostringstream out;
    print_findings_json(made.analysis, made.sources, out);
    const auto object = nlohmann::json::parse(out.str());
    EXPECT_EQ(object["chart"], "two_buttons");
    EXPECT_EQ(object["complete"], true);
    ASSERT_EQ(object["findings"].size(), 2U);
    const auto& both = object["findings"][0];
    EXPECT_EQ(both["code"], "branches-together");
    EXPECT_EQ(both["subject"], "t0");
    EXPECT_EQ(both["line"], 9);
    EXPECT_EQ(both["accepted"], nullptr);
    EXPECT_EQ(both["related"].size(), 1U);
    EXPECT_EQ(both["trace"]["steps"].back()["fired"], (nlohmann::json{"t0", "t1"}));
    EXPECT_EQ(object["findings"][1]["accepted"], "later");
}

TEST(Findings, StateHowFarOpenQueriesWereSearched) {
    Analysed made = analysed(std::string(two_buttons));
    made.analysis.questions = 9;
    made.analysis.obstacle = "stopped before completion";
    made.analysis.open = {{"action-race", "O", 3, 0},        {"action-race", "P", 3, 0},
                          {"step-never-active", "X1", 1, 0}, {"step-never-active", "X2", 0, 0},
                          {"total-instability", "", 4, 7},   {"out-of-range", "n", 0, 5}};
    std::ostringstream text, sarif;
    print_findings(made.analysis, made.sources, Colour::Plain, text);
    EXPECT_NE(text.str().find("inconclusive: 6 of 9 checks; stopped before completion\n"
                              "    action-race of `O`, `P`: not found in the first 3 instants\n"
                              "    out-of-range of `n`: not found in 5 evolutions\n"
                              "    step-never-active of `X2`: not explored\n"
                              "    step-never-active of `X1`: true in the first instant\n"
                              "    total-instability: not found in the first 4 instants, not found in 7 evolutions\n"),
              std::string::npos)
        << text.str();
    SarifLog log;
    add_findings(made.analysis, made.sources, log);
    print_sarif(log, "0", sarif);
    const auto invocation = nlohmann::json::parse(sarif.str())["runs"][0]["invocations"][0];
    EXPECT_EQ(invocation["executionSuccessful"], false);
    ASSERT_EQ(invocation["toolExecutionNotifications"].size(), 6U);
    EXPECT_EQ(invocation["toolExecutionNotifications"][2]["message"]["text"],
              "inconclusive (stopped before completion): step-never-active of `X1`: true in the first instant");
}

/// Checks the requirements of the SARIF 2.1.0 schema for a log of this kind.
void expect_sarif(const nlohmann::json& log) {
    EXPECT_EQ(log["version"], "2.1.0");
    ASSERT_EQ(log["runs"].size(), 1U);
    const auto& run = log["runs"][0];
    const auto& rules = run["tool"]["driver"]["rules"];
    EXPECT_TRUE(run["tool"]["driver"]["name"].is_string());
    const std::set<std::string> levels{"none", "note", "warning", "error"};
    std::set<std::string> ids;
    for (const auto& rule : rules) {
        EXPECT_TRUE(ids.insert(rule["id"]).second) << rule["id"];
        EXPECT_TRUE(rule["shortDescription"]["text"].is_string());
        EXPECT_TRUE(levels.contains(rule["defaultConfiguration"]["level"]));
    }
    EXPECT_TRUE(run["invocations"][0]["executionSuccessful"].is_boolean());
    for (const auto& result : run["results"]) {
        EXPECT_EQ(rules.at(result["ruleIndex"].get<std::size_t>())["id"], result["ruleId"]);
        EXPECT_TRUE(levels.contains(result["level"]));
        EXPECT_FALSE(result["message"]["text"].get<std::string>().empty());
        for (const auto& location : result["locations"]) {
            const auto& physical = location["physicalLocation"];
            EXPECT_EQ(physical["artifactLocation"]["uri"], "two%20buttons.grafcet");
            EXPECT_GE(physical["region"]["startLine"], 1);
            EXPECT_GE(physical["region"]["startColumn"], 1);
        }
        for (const auto& suppression : result.value("suppressions", nlohmann::json::array()))
            EXPECT_EQ(suppression["kind"], "inSource");
    }
}

TEST(Findings, AsSarifAreAValidLog) {
    const Analysed made = analysed(std::string(two_buttons));
    std::ostringstream out;
    SarifLog found;
    add_findings(made.analysis, made.sources, found);
    print_sarif(found, "0.1.0", out);
    const auto log = nlohmann::json::parse(out.str());
    expect_sarif(log);
    const auto& results = log["runs"][0]["results"];
    ASSERT_EQ(results.size(), 2U);
    EXPECT_EQ(results[0]["message"]["text"],
              "`t0` and `t1` leave the same step and can be cleared simultaneously; make their conditions exclusive. "
              "Inputs: a, b at 0 s: both transitions are cleared in the last instant");
    EXPECT_EQ(results[1]["suppressions"][0]["justification"], "later");
}

TEST(Exclusions, AcceptQuotesCommentsAndAllLineEndings) {
    Analysed made = analysed(std::string(two_buttons));
    Diagnostics diagnostics;
    const Id<Source> id = made.sources.add({"wiring.csv",
                                            "\xEF\xBB\xBFvariable1, variable2 ,reason\r\n# the panel\r\n\r\na,b,\"one "
                                            "\"\"switch\"\", two positions\"\r\n"});
    const auto rows = read_exclusions(id, made.sources, made.chart, diagnostics);
    ASSERT_TRUE(rows.has_value());
    ASSERT_EQ(rows->size(), 1U);
    EXPECT_EQ(rows->front().reason, "one \"switch\", two positions");
    EXPECT_EQ(rows->front().first.index, 0U);
    EXPECT_EQ(rows->front().second.index, 1U);
}

TEST(Exclusions, AcceptSemicolonsAsSeparators) {
    Analysed made = analysed(std::string(two_buttons));
    for (const char* head : {"", "sep=;\r\n", "# the panel, as wired\r\n"}) {
        SCOPED_TRACE(head);
        Diagnostics diagnostics;
        const Id<Source> id = made.sources.add(
            {"wiring.csv",
             std::string(head) + "variable1;variable2;reason\r\na;b;one switch, two positions\r\n;;\r\n"});
        const auto rows = read_exclusions(id, made.sources, made.chart, diagnostics);
        ASSERT_TRUE(rows.has_value());
        ASSERT_EQ(rows->size(), 1U);
        EXPECT_EQ(rows->front().reason, "one switch, two positions");
    }
}

TEST(Exclusions, InAnotherEncodingAreOneError) {
    Analysed made = analysed(std::string(two_buttons));
    Diagnostics diagnostics;
    const Id<Source> id =
        made.sources.add({"wiring.csv", "variable1;variable2;reason\r\na;b;T\xFCr zu\r\na;b;T\xFCr auf\r\n"});
    EXPECT_FALSE(read_exclusions(id, made.sources, made.chart, diagnostics).has_value());
    EXPECT_EQ(diagnostics.errors(), 1U);
    EXPECT_EQ(diagnostics.all().front().code, "invalid-utf8");
}

}  // namespace
}  // namespace grafverif
