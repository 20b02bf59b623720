// SPDX-License-Identifier: MIT
// Tests the remedies that `check` prints for an unfinished check: a check with the options of a remedy gives the
// verdicts that are printed for this remedy.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "report/remedies/trials.hpp"
#include "run_program.hpp"

namespace grafverif::app {
namespace {

using Json = nlohmann::json;

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream read(text);
    std::vector<std::string> words;
    for (std::string word; read >> word;) words.push_back(word);
    return words;
}

/// Returns `arguments` with the options of a remedy, which replace options of the same name.
std::vector<std::string> followed(std::vector<std::string> arguments, const std::vector<std::string>& remedy) {
    for (const std::string& word : remedy) {
        if (!word.starts_with("--")) continue;
        for (auto at = std::ranges::find(arguments, word); at != arguments.end();
             at = std::ranges::find(arguments, word))
            arguments.erase(at, at + 2);
    }
    arguments.insert(arguments.end(), remedy.begin(), remedy.end());
    return arguments;
}

Json checked(const std::vector<std::string>& arguments) {
    const Result result = grafverif(arguments);
    EXPECT_TRUE(result.err.find("internal error") == std::string::npos) << result.err;
    return Json::parse(result.out);
}

/// Runs a check with a bound, and each remedy that it prints; returns the number of confirmed verdicts.
std::size_t confirm_remedies(const std::vector<std::string>& arguments, Json& document) {
    document = checked(arguments);
    std::size_t confirmed = 0;
    for (const Json& remedy : document.value("remedies", Json::array())) {
        SCOPED_TRACE(remedy["options"].get<std::string>());
        if (remedy["decided"].empty()) continue;
        const Json again = checked(followed(arguments, words_of(remedy["options"])));
        for (const Json& decided : remedy["decided"]) {
            const auto found = std::ranges::find_if(
                again["properties"], [&](const Json& property) { return property["name"] == decided["name"]; });
            if (found == again["properties"].end()) {
                ADD_FAILURE() << decided["name"] << " is missing";
                continue;
            }
            EXPECT_EQ((*found)["verdict"], decided["verdict"]) << decided["name"];
            EXPECT_EQ((*found)["states"], decided["states"]) << decided["name"];
            ++confirmed;
        }
    }
    return confirmed;
}

/// True if the remedies are in the order of decreasing numbers of decided properties.
bool best_first(const Json& remedies) {
    return std::ranges::is_sorted(remedies, std::greater<>{},
                                  [](const Json& remedy) { return remedy["decided"].size(); });
}

const std::string gate =
    "grafcet gate { input GO, STOP; output L, R; internal N: int 0..9 = 0;\n"
    "initial step 0; step 1 { N := N + 1 on activation; L; } step 2 { R; }\n"
    "transition t0: 0 -> 1 when GO && !STOP && N < 9; transition t1: 1 -> 2 when 3s/X1; "
    "transition t2: 2 -> 0 when !GO; }\n"
    "closed_loop gates { controller gate; environment Go = push_button(OUT = GO); "
    "environment Stop = push_button(OUT = STOP); ";

TEST(Remedies, EachOneGivesThePrintedResult) {
    const Folder folder;
    const std::string file =
        folder.write("gate.grafcet", gate +
                                         "property both: never L && R; property two: reachable X2; "
                                         "property soon: GO leads to X1 || N == 9 || STOP; "
                                         "property back: always possible X0; }\n");
    Json document;
    const std::size_t confirmed =
        confirm_remedies({"check", file, "--max-states", "20", "--timeout", "600s", "--format", "json"}, document);
    EXPECT_GT(confirmed, 3u) << document.dump(2);
    EXPECT_TRUE(best_first(document["remedies"])) << document["remedies"].dump(2);
}

TEST(Remedies, SelectOnlyOpenProperties) {
    const Folder folder;
    const std::string file = folder.write(
        "gate.grafcet", gate + "property start expected violated: never X0; property both: never L && R; }\n");
    const Json document = checked({"check", file, "--max-states", "20", "--timeout", "600s", "--format", "json"});
    EXPECT_EQ(document["properties"][0]["verdict"], "violated");
    for (const Json& remedy : document["remedies"]) {
        EXPECT_NE(remedy["options"].get<std::string>().find("--property both"), std::string::npos) << remedy;
        EXPECT_EQ(remedy["options"].get<std::string>().find("start"), std::string::npos) << remedy;
    }
}

TEST(Remedies, OfTheUntimedModelAreValidForTheTimedLoop) {
    const Folder folder;
    const std::string file =
        folder.write("gate.grafcet", gate + "property both: never L && R; property slow: never X2 && N > 1; }\n");
    const Json document = checked({"check", file, "--max-states", "20", "--timeout", "600s", "--format", "json"});
    bool seen = false;
    for (const Json& remedy : document["remedies"]) {
        if (remedy["options"].get<std::string>().find("--untimed") == std::string::npos) continue;
        for (const Json& decided : remedy["decided"]) {
            seen = true;
            EXPECT_EQ(decided["verdict"], "holds") << decided;  // a violation need not exist in the timed loop
            EXPECT_TRUE(decided["preservation"].get<std::string>().starts_with("valid for the timed loop")) << decided;
        }
    }
    EXPECT_TRUE(seen) << document["remedies"];
}

TEST(Remedies, AreNotListedIfNoTrialDecidedAProperty) {
    const std::vector<Trial> trials = {{"--grain atomic --property both", {}, 0.25},
                                       {"--untimed --plant automata --property both", {}, 0.5}};
    EXPECT_EQ(
        remedies_text(trials),
        std::vector<std::string>{"no remedy was found: 2 trials with other options for 0.8 s decided no property; "
                                 "see docs/how-to/large-models.md"});
    EXPECT_EQ(
        remedies_text({trials.front()}, false),
        std::vector<std::string>{
            "no remedy was found: 1 trial with other options decided no property; see docs/how-to/large-models.md"});
}

TEST(Remedies, AreAbsentIfNoLimitEndedTheCheck) {
    const Folder folder;
    const std::string file = folder.write("gate.grafcet", gate + "property both: never L && R; }\n");
    const Json document = checked({"check", file, "--format", "json"});
    EXPECT_FALSE(document.contains("remedies"));
}

TEST(Remedies, AreInTextAndPageBeforeOtherAdvice) {
    const Folder folder;
    const std::string file = folder.write("gate.grafcet", gate + "property both: never L && R; }\n");
    const Result text = grafverif({"check", file, "--max-states", "20", "--timeout", "600s", "--stats"});
    const std::size_t remedies = text.out.find("\nremedies, tried on this model for ");
    ASSERT_NE(remedies, std::string::npos) << text.out;
    EXPECT_LT(text.out.find("both holds ("), text.out.size()) << text.out;
    EXPECT_EQ(text.out.find("`--"), text.out.find("`--", remedies)) << text.out;  // no option precedes the remedies
    const std::string page = folder.file("page.html");
    grafverif({"report", file, "-o", page, "--max-states", "20", "--timeout", "600s"});
    EXPECT_NE(folder.read("page.html").find("remedies, tried on this model"), std::string::npos);
}

}  // namespace
}  // namespace grafverif::app
