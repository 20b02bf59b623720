// SPDX-License-Identifier: MIT
// Tests `report`, which writes a page.
#include <fmt/format.h>
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

TEST(Report, ComponentOfMoreThanSixtyLocationsIsShownAsTables) {
    const Folder folder;
    const auto lamp = [&](int locations) {
        std::string text = "component ring(output A) { initial location l0;\n";
        for (int k = 1; k < locations; ++k)
            text += fmt::format("location l{0}; timed l{1} -> l{0} do A := {2};\n", k, k - 1, k % 2 == 0);
        return grafverif({"report",
                          folder.write("ring.grafcet",
                                       text + "}\ngrafcet lamp { input ON; output L; initial step 0 { L; } step 1;\n"
                                              "transition a: 0 -> 1 when ON; transition b: 1 -> 0 when !ON; }\n"
                                              "closed_loop room { controller lamp with stability_search;\n"
                                              "plant Ring = ring(A = ON); property NONE: never X0 && X1; }\n")})
            .out;
    };
    const std::string small = lamp(60), large = lamp(61);
    EXPECT_NE(small.find("class=\"drawing automaton\""), std::string::npos);
    EXPECT_EQ(large.find("class=\"drawing automaton\""), std::string::npos);
    EXPECT_NE(large.find("An automaton with 61 locations is too large to draw; see the tables."), std::string::npos);
    EXPECT_NE(large.find("<details open=\"\"><summary>Tables of this automaton"), std::string::npos);
}

TEST(Report, IsOneFileAndDeterministic) {
    const Folder folder;
    const std::string page = folder.file("report.html");
    EXPECT_EQ(grafverif({"report", blinking, "-o", page}).code, ExitCode::Done);
    EXPECT_EQ(folder.entries(), 1U);
    EXPECT_EQ(grafverif({"report", blinking}).out, folder.read("report.html"));
    EXPECT_NE(grafverif({"report", blinking, "--date", "a day"}).out.find("a day"), std::string::npos);
}

TEST(Report, RejectsATestSequenceForAProgram) {
    const Folder folder;
    folder.write("p.st", "PROGRAM p VAR_INPUT a : BOOL; END_VAR VAR_OUTPUT q : BOOL; END_VAR\nq := a;\nEND_PROGRAM\n");
    const std::string file = folder.write("loop.grafcet",
                                          "program pump = \"p.st\";\nclosed_loop l { controller pump every 10ms;\n"
                                          "environment a = free(OUT = a); property never_on: never q; }\n");
    const Result result = grafverif({"report", file, "--sequence", folder.write("test.csv", "step,a,q\n1,0,0\n")});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("`--sequence` applies only to charts; omit `--sequence` [only-for-charts]"),
              std::string::npos)
        << result.err;
}

TEST(Report, OfAProgramWithPropertiesHasTheVerdictsOfCheck) {
    const Folder folder;
    const std::string program =
        folder.write("p.st",
                     "PROGRAM p VAR_INPUT Go : BOOL; END_VAR VAR_OUTPUT Run : BOOL; END_VAR\n"
                     "INITIAL_STEP Idle: END_STEP\nSTEP Turning: Run(N); END_STEP\n"
                     "TRANSITION FROM Idle TO Turning := Go; END_TRANSITION\n"
                     "TRANSITION FROM Turning TO Idle := NOT Go; END_TRANSITION\nEND_PROGRAM\n");
    const std::string properties =
        folder.write("p.yaml",
                     "properties:\n  - {id: still, kind: invariant, expression: \"NOT Run\"}\n"
                     "  - {id: runs, kind: reachable, expression: \"Run\"}\n");
    const std::string page = folder.file("p.html"), junit = folder.file("p.xml");
    const Result report = grafverif({"report", program, "--properties", properties, "-o", page, "--junit", junit});
    const Result check = grafverif({"check", program, "--properties", properties});
    EXPECT_EQ(report.code, ExitCode::Verdict);
    EXPECT_EQ(report.code, check.code);
    EXPECT_NE(folder.read("p.xml").find("still"), std::string::npos);
    const nlohmann::json data = player_data(folder.read("p.html"));
    ASSERT_EQ(data["runs"].size(), 2U);
    EXPECT_EQ(data["runs"][0]["name"], "still");
    EXPECT_EQ(data["charts"][0]["steps"].size(), 2U);
    EXPECT_NE(check.out.find("Turning"), std::string::npos) << "the trace contains the active steps\n" << check.out;
    EXPECT_EQ(grafverif({"report", program, "--properties", properties}).out, folder.read("p.html"));

    folder.write("p.yaml", "properties:\n  - {id: still, kind: invariant, expression: \"NOT Rnu\"}\n");
    const Result wrong = grafverif({"report", program, "--properties", properties, "-o", page});
    EXPECT_EQ(wrong.code, ExitCode::Input);
    EXPECT_NE(wrong.err.find("p.yaml:2:51: error: unknown variable `Rnu`; did you mean `Run`?"), std::string::npos)
        << wrong.err;
    EXPECT_EQ(grafverif({"report", program, "--properties", folder.file("missing.yaml")}).code, ExitCode::Input);
    EXPECT_EQ(grafverif({"report", program, "--properties", properties, "--loop", "l"}).code, ExitCode::Input);
    EXPECT_EQ(grafverif({"report", program, "--properties", properties, "--sequence", "t.csv"}).code, ExitCode::Input);
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

/// Returns the first sentence of the page, which contains the summary verdict.
std::string glance(const std::vector<std::string>& arguments) {
    const std::string page = grafverif(arguments).out, begin = "<p class=\"glance ";
    const std::size_t from = page.find("<strong>", page.find(begin)) + 8;
    const std::size_t kind = page.find(begin) + begin.size();
    return page.substr(kind, page.find('"', kind) - kind) + ": " + page.substr(from, page.find('<', from) - from);
}

TEST(Report, SummaryIsPositiveOnlyIfEverythingIsAsExpected) {
    const Folder folder;
    const std::string lamp =
        "grafcet lamp { input B; output L; initial step 0; step 1 { L; }\n"
        "transition t0: 0 -> 1 when B; transition t1: 1 -> 0 when !B; }\n"
        "closed_loop shop { controller lamp; environment Button = push_button(OUT = B, GAP = 1s);\n";
    const std::string both =
        folder.write("both.grafcet", lamp + "property lit: reachable L; property dark: never L; }\n");
    EXPECT_EQ(glance({"report", both}), "bad: 1 verdict is unexpected.");
    EXPECT_EQ(glance({"report", both, "--property", "lit"}), "ok: Every property selected holds.");
    const std::string one = folder.write("one.grafcet", lamp + "property lit: reachable L; }\n");
    EXPECT_EQ(glance({"report", one}), "ok: Every property holds.");
    EXPECT_EQ(glance({"report", one, "--max-states", "3"}).substr(0, 8), "unknown:")
        << "the remaining states are not searched";
    const std::string observed =
        folder.write("observed.grafcet", lamp +
                                             "observer Eye { initial location 10; location 11; 10 -> 11 when L; }\n"
                                             "property lit: reachable L; property blind: never Eye.11; }\n");
    EXPECT_EQ(glance({"report", observed}), "unknown: 1 verdict is unknown.")
        << "the property is omitted from timed models";
    EXPECT_NE(grafverif({"report", observed}).out.find("id=\"property-blind\""), std::string::npos);
    const std::string idle = folder.write("idle.grafcet", lamp + "property r: X0 && X1 leads to L; }\n");
    EXPECT_EQ(glance({"report", idle}), "unknown: Every property holds, 1 vacuously.");
    EXPECT_EQ(glance({"report", (root / "samples/tanks/tanks.grafcet").string()}),
              "unknown: Every property holds; the chart analysis found 1 error (see Findings).");
}

TEST(Report, ListsTheAssumptionsOfTheVerdicts) {
    const Folder folder;
    const std::string file = folder.write("pair.grafcet", R"(
grafcet pair { input A, B; output L; constraint !(A && B); initial step 0; step 1 { L; }
    transition t0: 0 -> 1 when A && B; transition t1: 1 -> 0 when !A; }
closed_loop shop {
    controller pair;
    environment One = free(OUT = A);
    environment Two = free(OUT = B);
    constraint !(A && B);
    property p: reachable L;
}
)");
    const std::string free_inputs = "This model has no plant: every input can change at any time.";
    const auto says = [&](const std::vector<std::string>& more, const std::string& words) {
        std::vector<std::string> arguments = {"report", file};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return grafverif(arguments).out.find(words) != std::string::npos;
    };
    EXPECT_TRUE(says({}, "The environment behaves in every way that its components permit: One (free), Two (free)."));
    EXPECT_NE(grafverif({"report", blinking}).out.find("Button (push_button, GAP = 1s)."), std::string::npos);
    EXPECT_FALSE(says({}, "inputs always satisfy")) << "with a plant, a constraint is proved, not assumed";
    EXPECT_TRUE(says({"--untimed"}, free_inputs));
    EXPECT_FALSE(says({"--untimed"}, "inputs always satisfy"));
    EXPECT_TRUE(says({"--untimed", "--plant", "constraints"}, "The inputs always satisfy"));
    EXPECT_TRUE(says({"--chart", "pair"}, "assumed for the findings, but not for the verdicts"));
}

TEST(Report, DrawsEveryElementThatItsPlayerHighlights) {
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
    const std::string chart = (root / "samples/tanks/tanks.grafcet").string();
    const std::string table = (root / "samples/tanks/table2.csv").string();
    const Result result = grafverif({"report", chart, "--mode", "every-cycle", "--sequence", table});
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
    const Result refused = grafverif({"report", chart, "--sequence", wrong, "-o", folder.file("page.html")});
    EXPECT_EQ(refused.code, ExitCode::Input);
    EXPECT_NE(refused.err.find("[bad-sequence]"), std::string::npos) << refused.err;
    EXPECT_FALSE(fs::exists(folder.file("page.html")));
}

/// In an untimed run the time is the number of steps of the model.
TEST(Report, MarksMomentsThatAreNotStatesOfTheModel) {
    const Folder folder;
    const std::string file = folder.write(
        "lamp.grafcet",
        "grafcet lamp { input ON; output L; initial step 0; step 1 { L; } transition a: 0 -> 1 when ON; transition b: "
        "1 -> 0 "
        "when !ON; }\nclosed_loop room { controller lamp with stability_search; plant Lamp = lamp(ON = L);\n"
        "environment A = push_button(OUT = ON); property DARK: never L && !ON; property OUT: always !Lamp.lit; }\n");
    const nlohmann::json data =
        player_data(grafverif({"report", file, "--untimed", "--plant", "automata", "--schedule", "synchronous"}).out);
    std::size_t length = 0;
    for (const auto& run : data["runs"]) {
        if (run["property"].is_null()) {
            EXPECT_TRUE(run["inside"].empty());
            continue;
        }
        const auto& moments = run["run"]["moments"];
        std::vector<std::size_t> inside;
        for (std::size_t k = 1; k + 1 < moments.size(); ++k)
            if (moments[k]["time"] == moments[k + 1]["time"]) inside.push_back(k);
        EXPECT_EQ(run["inside"], inside) << run["name"];
        length += inside.size();
    }
    EXPECT_GE(length, 4U);
    const nlohmann::json timed = player_data(grafverif({"report", file}).out);
    for (const auto& run : timed["runs"])
        EXPECT_TRUE(run["inside"].empty()) << "a timed run contains each move of the network";
}

TEST(Report, OfAChartAloneChecksReachabilityOfItsSteps) {
    const std::string page = grafverif({"report", blinking, "--chart", "blinker"}).out;
    EXPECT_NE(page.find("id=\"property-reachable.X2\""), std::string::npos);
    const nlohmann::json data = player_data(page);
    EXPECT_TRUE(std::ranges::any_of(data["runs"], [](const auto& run) { return run["name"] == "reachable.X2"; }));
}

}  // namespace
}  // namespace grafverif::app
