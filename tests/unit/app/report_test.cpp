// SPDX-License-Identifier: MIT
// `report`: the page as the program writes it.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

const std::string blinking = (root / "samples/blinker/blinker.grafcet").string();

nlohmann::json player_data(const std::string& page) {
    const std::string begin = "id=\"data\">";
    const std::size_t from = page.find(begin) + begin.size();
    return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

TEST(Report, IsOneFileThatTheSameInputMakesAgain) {
    const Folder folder;
    const std::string page = folder.file("report.html");
    EXPECT_EQ(grafverif({"report", blinking, "-o", page}).code, ExitCode::Done);
    EXPECT_EQ(folder.entries(), 1U);
    EXPECT_EQ(grafverif({"report", blinking}).out, folder.read("report.html"));
    EXPECT_NE(grafverif({"report", blinking, "--date", "a day"}).out.find("a day"), std::string::npos);
}

TEST(Report, EndsAsCheckDoes) {
    const Folder folder;
    const std::string wrong = folder.write("wrong.grafcet", R"(
grafcet press { input S; output M; initial step 0; step 1 { M; } transition t: 0 -> 1 when S; }
closed_loop shop {
    controller press;
    environment Start = free(OUT = S);
    property never_runs: never M;
}
)");
    EXPECT_EQ(grafverif({"report", wrong}).code, ExitCode::Verdict);
    EXPECT_EQ(grafverif({"report", wrong, "--max-states", "2"}).code,
              grafverif({"check", wrong, "--max-states", "2"}).code);
    EXPECT_EQ(grafverif({"report", folder.write("broken.grafcet", "grafcet g {")}).code, ExitCode::Input);
    EXPECT_EQ(grafverif({"report", wrong, "--property", "nobody"}).code, ExitCode::Input);
}

TEST(Report, DrawsEveryElementThatItsPlayerLights) {
    for (const char* sample : {"samples/oven_door/oven_door.grafcet",
                               "samples/assembly_station/assembly_station.grafcet", "samples/tanks/tanks.grafcet"}) {
        const std::string page = grafverif({"report", (root / sample).string(), "--untimed"}).out;
        const nlohmann::json data = player_data(page);
        ASSERT_FALSE(data["charts"].empty()) << sample;
        for (const auto& chart : data["charts"]) {
            EXPECT_NE(page.find("<figure id=\"" + chart["figure"].get<std::string>() + "\""), std::string::npos);
            for (const auto& [kind, ids] : chart["ids"].items())
                for (const auto& id : ids) {
                    const std::string mark = " id=\"" + id.get<std::string>() + "\"";
                    const std::size_t at = page.find(mark);
                    EXPECT_NE(at, std::string::npos) << sample << ": " << mark;
                    EXPECT_EQ(page.find(mark, at + 1), std::string::npos) << sample << ": twice " << mark;
                }
        }
    }
}

TEST(Report, PlaysTheSequencesOfATest) {
    const std::string tanks = (root / "samples/tanks/tanks.grafcet").string();
    const std::string table = (root / "samples/tanks/table2.csv").string();
    const Result result = grafverif({"report", tanks, "--mode", "every-cycle", "--sequence", table});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    const nlohmann::json data = player_data(result.out);
    const auto run = std::ranges::find_if(data["runs"], [](const auto& one) { return one["name"] == "test-1"; });
    ASSERT_NE(run, data["runs"].end());
    EXPECT_EQ((*run)["kind"], "test");
    ASSERT_EQ((*run)["rows"].size(), 3U) << "power-on and two steps";
    const auto& moments = (*run)["run"]["moments"];
    std::vector<std::string> active;
    for (const std::size_t step : moments.back()["situation"])
        active.push_back((*run)["run"]["steps"][step]["name"].get<std::string>());
    EXPECT_EQ(active, (std::vector<std::string>{"2", "6"}));

    const Folder folder;
    const std::string wrong = folder.write("wrong.csv", "s,h1\n0,1\n");
    const Result refused = grafverif({"report", tanks, "--sequence", wrong, "-o", folder.file("page.html")});
    EXPECT_EQ(refused.code, ExitCode::Input);
    EXPECT_NE(refused.err.find("[bad-sequence]"), std::string::npos) << refused.err;
    EXPECT_FALSE(fs::exists(folder.file("page.html")));
}

TEST(Report, OfAChartAloneAsksForItsSteps) {
    const std::string page = grafverif({"report", station, "--chart", "testing_station"}).out;
    EXPECT_NE(page.find("id=\"property-reachable.X12\""), std::string::npos);
    const nlohmann::json data = player_data(page);
    EXPECT_TRUE(std::ranges::any_of(data["runs"], [](const auto& run) { return run["name"] == "reachable.X12"; }));
}

}  // namespace
}  // namespace grafverif::app
