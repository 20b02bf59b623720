// SPDX-License-Identifier: MIT
// `draw`: charts of files as drawings.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <pugixml.hpp>

#include "grafverif/grafverif.hpp"
#include "run_program.hpp"
#include "support/drawing_faults.hpp"

namespace grafverif::app {
namespace {

namespace fs = std::filesystem;

/// The group of that id in the drawing that the arguments make.
pugi::xml_node group(pugi::xml_document& document, const std::vector<std::string>& arguments, const char* id) {
    const Result result = grafverif(arguments);
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    EXPECT_TRUE(document.load_string(result.out.c_str())) << result.out;
    return document.child("svg").find_child_by_attribute("g", "id", id);
}

std::string class_of(const pugi::xml_node& node) { return node.attribute("class").value(); }

TEST(Draw, NothingLiesOnAnythingElseInAnySampleOrElementOfTheStandard) {
    int drawn = 0;
    for (const fs::path& folder : {root / "samples", root / "bench/stations", root / "tests/unit/app/elements"})
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            if (entry.path().extension() != ".grafcet") continue;
            const Reading reading = read_file(entry.path().string());
            ASSERT_TRUE(reading.model) << reading.complaints();
            for (const Id<Chart> chart : reading.model->charts.ids())
                for (const Notation notation : {Notation::Iec, Notation::Text}) {
                    const Drawing drawing = drawing_of(*reading.model, chart, {.notation = notation});
                    EXPECT_EQ(faults(drawing), std::vector<std::string>()) << entry.path();
                    ++drawn;
                }
        }
    EXPECT_GT(drawn, 30);
}

TEST(Draw, StepsOfTheSituationAreMarked) {
    const std::string station = (root / "samples/testing_station/faulty.grafcet").string();
    pugi::xml_document document;
    EXPECT_EQ(class_of(group(document, {"draw", station, "--situation", "4,W0"}, "step-4")), "step active");
    const auto by_class = [&](const char* id) {
        return class_of(document.child("svg").find_child_by_attribute("g", "id", id));
    };
    EXPECT_EQ(by_class("step-0"), "step initial");
    EXPECT_EQ(by_class("step-watchdog_out-W0"), "step initial active");
}

TEST(Draw, AStepThatIsNotThereIsRefused) {
    const std::string door = (root / "samples/oven_door/oven_door.grafcet").string();
    const Result result = grafverif({"draw", door, "--situation", "1,99"});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("has no step `99`"), std::string::npos) << result.err;
}

TEST(Draw, AStepOfSeveralPartialChartsIsAskedFor) {
    const Folder folder;
    const std::string file =
        folder.write("two.grafcet",
                     "grafcet two { input a; partial G1 { initial step 1; transition t: 1 -> 1 when a; }\n"
                     "partial G2 { initial step 1; transition u: 1 -> 1 when a; } }\n");
    const Result unclear = grafverif({"draw", file, "--situation", "1"});
    EXPECT_EQ(unclear.code, ExitCode::Input);
    EXPECT_NE(unclear.err.find("G1.X1"), std::string::npos) << unclear.err;
    pugi::xml_document document;
    EXPECT_EQ(class_of(group(document, {"draw", file, "--situation", "G2.1"}, "step-G2-1")), "step initial active");
}

TEST(Draw, LogicIsWrittenAsTheStandardOrTheFileDoes) {
    const Folder folder;
    const std::string file =
        folder.write("logic.grafcet",
                     "grafcet logic { input a, b, c; internal n: int 0..9 = 0; initial step 1; step 2;\n"
                     "transition t1: 1 -> 2 when (a || !b) && !(c && !a) && n >= 3;\n"
                     "transition t2: 2 -> 1 when rise(a) || 3s/X2; }\n");
    const auto text = [&](const char* notation, const char* id) {
        pugi::xml_document document;
        std::string all;
        const pugi::xml_node condition = group(document, {"draw", file, "--notation", notation}, id);
        for (const pugi::xml_node line : condition.children("text"))
            for (const pugi::xml_node run : line.children())
                all += std::string(run.name()) == "tspan" ? "{" + std::string(run.child_value()) + "}" : run.value();
        return all;
    };
    EXPECT_EQ(text("iec", "condition-t1"), "(a + {b}) · {c · ¬(a)} · [n ≥ 3]");
    EXPECT_EQ(text("text", "condition-t1"), "(a || !b) && !(c && !a) && n >= 3");
    EXPECT_EQ(text("iec", "condition-t2"), "↑a + 3s/X2");
}

TEST(Draw, AnUpwardLinkFromAFoldedChartIsNamedAtBothEndsOfEachCut) {
    const std::string station = (root / "samples/testing_station/testing_station.grafcet").string();
    const Result result = grafverif({"draw", station, "--columns", "3"});
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(result.out.c_str()));
    std::map<std::string, int> numbers;
    for (const pugi::xml_node node : document.child("svg").children("g"))
        if (class_of(node) == "reference") ++numbers[node.attribute("data-number").value()];
    EXPECT_GE(numbers.size(), 4U);
    for (const auto& [number, ends] : numbers) EXPECT_EQ(ends, 2) << number;
}

TEST(Draw, LongNamesAreCutShort) {
    const Folder folder;
    const std::string name(1'000, 'n');
    const std::string file = folder.write("long.grafcet", "grafcet " + name + " { input " + name + "; initial step " +
                                                              name + "; transition " + name + ": " + name + " -> " +
                                                              name + " when " + name + "; }\n");
    const Result result = grafverif({"draw", file});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err.substr(0, 1000);
    EXPECT_LT(result.out.size(), 10'000U);
}

}  // namespace
}  // namespace grafverif::app
