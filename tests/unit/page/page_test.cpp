// SPDX-License-Identifier: MIT
#include "page/page.hpp"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>

#include "content.hpp"

namespace grafverif {
namespace {

/// Returns the SHA-256 hash in hexadecimal, computed by an independent program.
std::string sha256(const std::string& text) {
    const auto file = std::filesystem::temp_directory_path() / ("grafverif-page-" + std::to_string(::getpid()));
    std::ofstream(file, std::ios::binary) << text;
    std::FILE* const pipe =
        ::popen((std::string(CMAKE_PROGRAM) + " -E sha256sum '" + file.string() + "'").c_str(), "r");
    std::array<char, 65> hash = {};
    const std::size_t read = std::fread(hash.data(), 1, 64, pipe);
    ::pclose(pipe);
    std::filesystem::remove(file);
    return std::string(hash.data(), read);
}

std::string hex_of_base64(const std::string& text) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string hex;
    unsigned bits = 0, count = 0;
    for (const char letter : text) {
        if (letter == '=') break;
        bits = (bits << 6U) | static_cast<unsigned>(letters.find(letter));
        for (count += 6; count >= 4 && hex.size() < 64; count -= 4)
            hex += "0123456789abcdef"[(bits >> (count - 4)) & 15U];
    }
    return hex;
}

TEST(Page, ShowsTheVerdictTheAssumptionsAndTheFormulas) {
    const Made made = page_of_text(press);
    EXPECT_NE(made.page.find("1 verdict is unexpected."), std::string::npos);
    EXPECT_NE(made.page.find("3 hold, 1 violated"), std::string::npos);
    EXPECT_NE(made.page.find("<code>never MOTOR</code>"), std::string::npos);
    EXPECT_NE(made.page.find("a PLC cycle takes no time"), std::string::npos);
    EXPECT_NE(made.page.find("Start (free), Done (free)"), std::string::npos);
    EXPECT_NE(made.page.find("CF_T0"), std::string::npos) << "the equations";
    EXPECT_NE(made.page.find("data-run=\"idle\""), std::string::npos);
}

TEST(Page, FoldsHoldingPropertiesAndOpensOthers) {
    const Made made = page_of_text(press);
    EXPECT_NE(made.page.find("<details class=\"property bad\" id=\"property-idle\" open"), std::string::npos);
    EXPECT_NE(made.page.find("<details class=\"property ok\" id=\"property-sound\">"), std::string::npos);
    EXPECT_LT(made.page.find("property-idle"), made.page.find("property-sound")) << "unexpected verdicts come first";
}

TEST(Page, IsDeterministicAndHasADateOnlyIfGiven) {
    const std::string page = page_of_text(press).page;
    EXPECT_EQ(page, page_of_text(press).page);
    EXPECT_EQ(page.find("2031-05-06"), std::string::npos);
    EXPECT_NE(page_of_text(press, "test.grafcet", "2031-05-06").page.find("2031-05-06"), std::string::npos);
}

TEST(Page, AllowsOnlyItsScriptAndStyleByTheirHashes) {
    const std::string page = page_of_text(press).page;
    std::string policy = between(page, "http-equiv=\"Content-Security-Policy\" content=\"", "\"");
    EXPECT_NE(policy.find("default-src"), std::string::npos);
    EXPECT_EQ(policy.find("unsafe"), std::string::npos);
    EXPECT_EQ(hex_of_base64(between(policy, "script-src &apos;sha256-", "&apos;") +
                            between(policy, "script-src 'sha256-", "'")),
              sha256(between(page, "<script type=\"module\">", "</script>")));
    EXPECT_EQ(hex_of_base64(between(policy, "style-src &apos;sha256-", "&apos;") +
                            between(policy, "style-src 'sha256-", "'")),
              sha256(between(page, "<style>", "</style>")));
    EXPECT_NE(policy.find("img-src data:;"), std::string::npos) << "pictures of drawings, not of other machines";
    EXPECT_EQ(count_of(page, "<script"), 2U);
    EXPECT_EQ(count_of(page, " style="), 0U) << "the policy forbids them";
    for (const char* outside : {"http://", "https://", "src=", "@import", "url("}) {
        const std::string script = between(page, "<script type=\"module\">", "</script>");
        std::string rest = page;
        rest.erase(rest.find(script), script.size());
        const std::size_t namespaces = std::string(outside) == "http://" ? count_of(rest, "http://www.w3.org/") : 0;
        EXPECT_EQ(count_of(rest, outside), namespaces) << outside;
    }
}

TEST(Page, ShowsHostileTextAsText) {
    const std::string hostile = "</script><script>alert(1)</script><img src=x onerror=alert(2)> \xE2\x80\xAE'&";
    std::string text = press;
    text.replace(text.find("the motor never runs"), 20, hostile);
    const Made made = page_of_text(text, hostile, hostile);
    EXPECT_EQ(count_of(made.page, "<script"), 2U);
    EXPECT_EQ(count_of(made.page, "</script>"), 2U);
    EXPECT_EQ(made.page.find("<img"), std::string::npos);
    EXPECT_EQ(made.page.find("\xE2\x80\xAE"), std::string::npos) << "it changes the direction of the following text";
    EXPECT_NE(made.page.find("&lt;script&gt;alert(1)"), std::string::npos);
    EXPECT_FALSE(made.data.is_discarded());
}

TEST(Page, HasDataForEveryElementThatARunNames) {
    const Made made = page_of_text(press);
    ASSERT_FALSE(made.data.is_discarded());
    std::set<std::string> names;
    for (const auto& run : made.data["runs"]) {
        EXPECT_TRUE(names.insert(run["name"]).second) << "names of runs must be unique";
        ASSERT_FALSE(run["rows"].empty());
        const auto& trace = run["run"];
        std::size_t moment = 0;
        for (const auto& row : run["rows"]) {
            EXPECT_GE(row["moment"], moment);
            moment = row["moment"];
        }
        EXPECT_LT(moment, trace["moments"].size());
        ASSERT_EQ(run["charts"].size(), trace["controllers"].size());
        for (std::size_t k = 0; k < trace["controllers"].size(); ++k) {
            const auto& chart = made.data["charts"][run["charts"][k].get<std::size_t>()];
            EXPECT_EQ(chart["ids"]["steps"].size(), trace["controllers"][k]["steps"].size());
            EXPECT_EQ(chart["steps"].size(), trace["controllers"][k]["steps"].size());
            EXPECT_EQ(chart["ids"]["transitions"].size(), trace["controllers"][k]["transitions"].size());
            EXPECT_EQ(chart["transitions"].size(), trace["controllers"][k]["transitions"].size());
            EXPECT_EQ(chart["timed"].size(), run["conditions"][k].size());
        }
    }
    EXPECT_TRUE(names.contains("idle")) << "the counterexample";
    EXPECT_TRUE(names.contains("rests")) << "the witness";
}

TEST(Page, ShowsEachComponentDrawnAndAsTables) {
    const Made made = page_of_text(press);
    const std::string figure = made.data["plant"]["Start"];
    EXPECT_EQ(made.data["plant"]["Done"], figure) << "both are instances of one component";
    EXPECT_EQ(count_of(made.page, "<figure id=\"" + figure + "\""), 1U);
    EXPECT_NE(made.page.find("<svg></svg></div>\n<details><summary>Tables of this automaton"), std::string::npos)
        << made.page;
}

TEST(Page, OfAChartAloneStatesThatItsInputsAreFree) {
    const Made made = page_of_text(press.substr(0, press.find("closed_loop")));
    EXPECT_NE(made.page.find("There is no plant: every input can change at any time."), std::string::npos);
    EXPECT_NE(made.page.find("property-reachable.X2"), std::string::npos);
    EXPECT_EQ(made.page.find("id=\"plant\""), std::string::npos);
}

TEST(Page, StatesTheLengthOfARunThatIsTooLongToPlay) {
    const ParseResult reading = read_string(press, "test.grafcet");
    const Model& model = *reading.model;
    Diagnostics diagnostics;
    PageContent content{.model = model, .sources = reading.sources, .loop = {0}};
    content.report = *check(model, {0}, {}, {}, diagnostics);
    content.charts.push_back({.chart = {0}, .equations = *equations_of(model, {0}, diagnostics)});
    ChartRun& run = *content.report.answers.front().trace;
    run.moments.resize(1'000'000, run.moments.back());
    const std::string page = page_of(content);
    EXPECT_NE(page.find("The counterexample has 1000000 steps"), std::string::npos);
    EXPECT_EQ(page.find("data-run=\"idle\""), std::string::npos);
    EXPECT_LT(page.size(), 1'000'000U);
    for (PropertyResult& answer : content.report.answers)
        if (answer.trace) answer.trace->moments.resize(60'000, answer.trace->moments.back());
    EXPECT_EQ(count_of(page_of(content), "\"loop_from\":"), 1U) << "two runs would exceed the limit";
}

TEST(Page, SummaryIsPositiveOnlyIfTheChartHasNoErrors) {
    const ParseResult reading = read_string(press, "test.grafcet");
    const Model& model = *reading.model;
    Diagnostics diagnostics;
    PageContent content{.model = model, .sources = reading.sources, .requested = {"sound"}, .loop = {0}};
    content.report = *check(model, {0}, {}, {.properties = {"sound"}}, diagnostics);
    content.charts.push_back({.chart = {0}, .equations = *equations_of(model, {0}, diagnostics)});
    const auto glance = [&] { return between(page_of(content), "<p class=\"glance ", "</strong>"); };
    EXPECT_EQ(glance(), "ok\"><strong>Every property selected holds.");
    content.charts[0].analysis.open.push_back({.code = "total-instability"});
    content.charts[0].analysis.obstacle = "stopped at the time limit";
    EXPECT_EQ(glance(),
              "unknown\"><strong>Every property selected holds; the chart analysis is incomplete (see Findings).");
}

TEST(Page, StatesARemedyIfThereAreNoProperties) {
    const ParseResult reading = read_string(press, "test.grafcet");
    PageContent content{.model = *reading.model, .sources = reading.sources, .requested = {"none"}, .loop = {0}};
    const std::string page = page_of(content);
    EXPECT_NE(page.find("There are no properties. Declare one in the closed loop, for example <code>property NAME: "
                        "never A &amp;&amp; B;</code>"),
              std::string::npos);
    EXPECT_EQ(page_of_text(press).page.find("There are no properties"), std::string::npos);
}

TEST(Page, CountsUsedStepsAndTransitions) {
    const std::string page = page_of_text(press).page;
    const std::string coverage = between(page, "<section id=\"coverage\">", "</section>");
    EXPECT_NE(coverage.find("3 of 3"), std::string::npos) << coverage;
    EXPECT_NE(coverage.find("2 of 3"), std::string::npos) << coverage;
    EXPECT_NE(coverage.find("T2"), std::string::npos) << "no run clears it";
}

}  // namespace
}  // namespace grafverif
