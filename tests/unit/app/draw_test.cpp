// SPDX-License-Identifier: MIT
// Tests `draw`, which draws the charts of files.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <pugixml.hpp>

#include "grafverif/grafverif.hpp"
#include "pipeline/chart_text.hpp"
#include "run_program.hpp"
#include "support/drawing_faults.hpp"

namespace grafverif::app {
namespace {

namespace fs = std::filesystem;

/// Returns the group with the id `id` in the drawing that the arguments produce.
pugi::xml_node group(pugi::xml_document& document, const std::vector<std::string>& arguments, const char* id) {
    const Result result = grafverif(arguments);
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    EXPECT_TRUE(document.load_string(result.out.c_str())) << result.out;
    return document.child("svg").find_child_by_attribute("g", "id", id);
}

std::string class_of(const pugi::xml_node& node) { return node.attribute("class").value(); }

TEST(Draw, ElementsDoNotOverlapInAnySampleOrElementOfTheStandard) {
    int drawn = 0;
    for (const fs::path& folder : {root / "samples", root / "bench/stations", root / "tests/unit/app/elements"})
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            if (entry.path().extension() != ".grafcet") continue;
            const ParseResult reading = read_file(entry.path().string());
            ASSERT_TRUE(reading.model) << reading.diagnostics_text();
            for (const Id<Chart> chart : reading.model->charts.ids())
                for (const Notation notation : {Notation::Iec, Notation::Text}) {
                    const Drawing drawing = drawing_of(*reading.model, chart, {.notation = notation}, reading.sources);
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

TEST(Draw, UnknownStepIsRejected) {
    const std::string door = (root / "samples/oven_door/oven_door.grafcet").string();
    const Result result = grafverif({"draw", door, "--situation", "1,99"});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("has no step `99`"), std::string::npos) << result.err;
}

TEST(Draw, AmbiguousStepNamesAreRejected) {
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

TEST(Draw, LogicIsWrittenAsInTheStandardOrAsInTheFile) {
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

std::string words_of(const pugi::xml_node& element) {
    std::string words;
    for (const pugi::xml_node line : element.children("text"))
        words += (words.empty() ? "" : " ") + std::string(line.child_value());
    return words;
}

TEST(Draw, ShowsTheChartOfAProgramWithItsConditionsAndActions) {
    const std::string spindle = (root / "samples/spindle/spindle.grafcet").string();
    pugi::xml_document document;
    EXPECT_EQ(
        class_of(group(document, {"draw", spindle, "--chart", "spindle", "--situation", "Locking"}, "step-Locking")),
        "step active");
    const auto words = [&](const char* id) {
        return words_of(document.child("svg").find_child_by_attribute("g", "id", id));
    };
    EXPECT_EQ(words("condition-T4"), "Coasting.T >= T#2s");
    EXPECT_EQ(words("action-c0"), "N Lock");
}

TEST(Draw, RejectsAProgramWithoutSteps) {
    const Result result =
        grafverif({"draw", (root / "samples/tank_program/tank.grafcet").string(), "--chart", "filling"});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("`filling` is a PLC program, but only charts with steps can be drawn"), std::string::npos)
        << result.err;
}

TEST(Draw, TextNotationShowsTermsAsWritten) {
    const Folder folder;
    const std::string file = folder.write("written.grafcet",
                                          "grafcet written { input a, b; output L, M; internal n: int 0..9 = 0; "
                                          "initial step 1 { L if a || a after 2s; }\n"
                                          "step 2 { M := true && true on event rise(a) && rise(a); }\n"
                                          "transition t1: 1 -> 2 when a && a && b;\n"
                                          "transition t2: 2 -> 1 when a => b do n := 1 + 1; }\n");
    const auto text = [&](const char* notation, const char* id) {
        pugi::xml_document document;
        return words_of(group(document, {"draw", file, "--notation", notation}, id));
    };
    EXPECT_EQ(text("text", "condition-t1"), "a && a && b");
    EXPECT_EQ(text("iec", "condition-t1"), "a · b");
    EXPECT_EQ(text("text", "condition-t2"), "a => b");
    EXPECT_EQ(text("text", "action-c0"), "L (a || a) && 2s/X1") << "a disjunction next to a delay is in parentheses";
    EXPECT_EQ(text("text", "action-s0"), "M := true && true rise(a) && rise(a)");
    EXPECT_EQ(text("text", "action-s1"), "n := 1 + 1");
}

TEST(Draw, CommentsOfStepsAreInQuotationMarks) {
    const Folder folder;
    const std::string file = folder.write("comments.grafcet",
                                          "grafcet comments {\n    input a;\n    output L;\n"
                                          "    // not of a step\n"
                                          "    initial step 1;  // rests\n"
                                          "    step 2 {  /* lit */\n        L;  // of the action\n    }\n"
                                          "    step 3 {\n        L;  // of the action\n    }  // dark\n"
                                          "    transition t1: 1 -> 2 when a;  // of the transition\n"
                                          "    transition t2: 2 -> 3 when a;\n"
                                          "    transition t3: 3 -> 1 when a;\n}\n");
    pugi::xml_document document;
    group(document, {"draw", file}, "step-1");
    std::vector<std::string> comments;
    for (const pugi::xml_node element : document.child("svg").children("g"))
        if (class_of(element) == "comment") comments.push_back(words_of(element));
    EXPECT_EQ(comments, (std::vector<std::string>{"\"rests\"", "\"lit\"", "\"dark\""}));
}

TEST(Draw, EnclosingStepsAreSquaresWithALineAcrossEachCorner) {
    const Folder folder;
    const std::string file = folder.write(
        "enclosing.grafcet",
        "grafcet enclosing { input a; initial step 0; enclosing step 1 encloses G1; transition t1: 0 -> 1 when a;\n"
        "partial G1 { linked step 2; transition u: 2 -> 2 when a; } }\n");
    pugi::xml_document document;
    const pugi::xml_node step = group(document, {"draw", file}, "step-1");
    ASSERT_TRUE(step.child("rect"));
    ASSERT_TRUE(step.child("path"));
    const pugi::xml_node rect = step.child("rect");
    const int x = rect.attribute("x").as_int(), y = rect.attribute("y").as_int();
    EXPECT_EQ(std::string(step.child("path").attribute("d").value())
                  .find("M" + std::to_string(x + 9) + " " + std::to_string(y) + "h"),
              0U)
        << "the corners lie within the square";
    EXPECT_EQ(words_of(document.child("svg").find_child_by_attribute("g", "id", "transition-t1")), "(t1)");
}

TEST(Draw, FramesOfPartialChartsFillThePage) {
    const Folder folder;
    std::string text = "grafcet parts { input a;\n";
    const auto part = [&](const std::string& name, int steps) {
        text += "partial " + name + " { initial step 0;";
        for (int k = 1; k < steps; ++k)
            text += " step " + std::to_string(k) + "; transition t" + name + std::to_string(k) + ": " +
                    std::to_string(k - 1) + " -> " + std::to_string(k) + " when a;";
        text += " transition t" + name + "0: " + std::to_string(steps - 1) + " -> 0 when a; }\n";
    };
    part("Long", 9);
    for (int k = 0; k < 30; ++k) part("P" + std::to_string(k), 2);
    const ParseResult reading = read_string(text + "}\n", "parts.grafcet");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    const Drawing drawing = drawing_of(*reading.model, Id<Chart>{0});
    EXPECT_EQ(faults(drawing), std::vector<std::string>());
    std::int64_t framed = 0;
    for (const Drawing::Element& element : drawing.elements)
        if (element.classes.starts_with("partial-chart"))
            framed += std::int64_t{element.boxes.at(0).size.width} * element.boxes.at(0).size.height;
    const std::int64_t page = std::int64_t{drawing.size.width} * drawing.size.height;
    EXPECT_GT(framed * 100, page * 60) << "rows as high as the longest chart leave more than half of the page empty";
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
