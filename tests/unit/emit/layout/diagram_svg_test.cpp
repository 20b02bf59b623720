// SPDX-License-Identifier: MIT
// Tests automata as SVG, which are read back: the elements on the page satisfy the layout rules, and the diagram is
// complete.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <pugixml.hpp>
#include <random>
#include <sstream>

#include "emit/layout/diagram.hpp"
#include "grafverif/grafverif.hpp"
#include "scene.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

using layout::Box;

struct Shown {
    Scene scene = {};
    std::vector<Box> nodes = {};
    std::string names = {}, labels = {};  ///< all text, with line ends replaced by blanks
    std::size_t arrows = 0;               ///< number of lines, including those without a target
};

Box rectangle(pugi::xml_node node) {
    return {{node.attribute("x").as_int(), node.attribute("y").as_int()},
            {node.attribute("width").as_int(), node.attribute("height").as_int()}};
}

/// Returns the box of a text in a font whose characters have equal width.
Box text_box(pugi::xml_node text) {
    std::size_t characters = 0;
    for (const char c : std::string_view(text.text().get())) characters += (c & 0xC0) != 0x80 ? 1 : 0;
    return {{text.attribute("x").as_int(), text.attribute("y").as_int() - 10}, {static_cast<int>(7 * characters), 14}};
}

void add_lines(const std::string& path, std::size_t net, Shown& shown) {
    std::istringstream in(path);
    for (char command = 0, comma = 0; in >> command;) {
        layout::Point at;
        in >> at.x >> comma >> at.y;
        if (command == 'M') shown.scene.lines.push_back({{}, net});
        shown.scene.lines.back().points.push_back(at);
        shown.arrows += command == 'M' ? 1 : 0;
    }
}

bool is_within(const Box& inner, const Box& outer) {
    return inner.at.x >= outer.at.x && inner.at.y >= outer.at.y &&
           inner.at.x + inner.size.width <= outer.at.x + outer.size.width &&
           inner.at.y + inner.size.height <= outer.at.y + outer.size.height;
}

/// Reads the diagram back. Fails the test if a layout rule is violated.
Shown shown(const Diagram& diagram) {
    std::ostringstream out;
    emit_svg(diagram, out);
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(out.str().c_str()));
    Shown found;
    for (const pugi::xml_node node : document.child("svg").children()) {
        const std::string kind = node.attribute("class").value();
        if (kind == "node") found.nodes.push_back(rectangle(node));
        if (kind == "name") {
            EXPECT_TRUE(is_within(text_box(node), found.nodes.back())) << node.text().get();
            found.names += std::string(node.text().get()) + ' ';
        }
        if (kind == "label") {
            found.scene.boxes.push_back(text_box(node));
            found.labels += std::string(node.text().get()) + ' ';
        }
        if (std::string_view(node.name()) == "path") add_lines(node.attribute("d").value(), node.hash_value(), found);
        if (std::string_view(node.name()) == "rect" && kind.empty()) found.scene.page = rectangle(node);
    }
    found.scene.boxes.insert(found.scene.boxes.end(), found.nodes.begin(), found.nodes.end());
    EXPECT_EQ(faults(found.scene), std::vector<std::string>{});
    EXPECT_EQ(found.nodes.size(), diagram.nodes.size());
    for (std::size_t k = 0; k < diagram.nodes.size(); ++k)
        EXPECT_NE(
            found.names.find((diagram.numbered ? std::to_string(k) + ": " : "") + diagram.nodes[k].lines.front() + ' '),
            std::string::npos)
            << k;
    for (const Diagram::Arrow& arrow : diagram.arrows)
        for (const std::string& line : arrow.lines) EXPECT_NE(found.labels.find(line), std::string::npos) << line;
    return found;
}

std::string random_condition(std::mt19937& random) {
    static const char* const terms[] = {"START", "not V_IN", "H_OUT", "↑a", "not T_X2_3s_Q", "LEVEL <= 12"};
    std::string text = terms[random() % 6];
    for (std::size_t more = random() % 9; more > 0; --more)
        text += std::string(random() % 3 == 0 ? " or " : " and ") + terms[random() % 6];
    return text;
}

Diagram random_diagram(std::mt19937& random, std::size_t most) {
    Diagram diagram{"random", {}, {}};
    const std::size_t nodes = 1 + random() % most;
    for (std::size_t k = 0; k < nodes; ++k) {
        diagram.nodes.push_back({{"{" + std::to_string(random() % 99) + "}"}, k == 0});
        for (std::size_t lines = random() % 3; lines > 0; --lines) diagram.nodes.back().lines.emplace_back("V1, W2");
    }
    for (std::size_t k = random() % (3 * nodes); k > 0; --k) {
        const std::size_t from = random() % nodes;
        const bool dashed = random() % 8 == 0;
        diagram.arrows.push_back({from, dashed ? from : random() % nodes, {random_condition(random)}, dashed});
        if (random() % 4 == 0) diagram.arrows.back().lines.push_back(random_condition(random));
    }
    return diagram;
}

TEST(RandomizedDiagramSvg, AllOfADiagramIsOnThePageAndNothingOverlaps) {
    for (int seed = 1; seed <= test_size(60); ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(static_cast<unsigned>(seed));
        const Diagram diagram = random_diagram(random, 30);
        ASSERT_EQ(shown(diagram).arrows, diagram.arrows.size());
        if (::testing::Test::HasFailure()) return;
    }
}

TEST(DiagramSvg, AutomataAndMachinesOfTheSamplesAreDrawn) {
    int drawn = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(GRAFVERIF_SOURCE_DIR "/samples")) {
        if (entry.path().extension() != ".grafcet") continue;
        ParseResult reading = read_file(entry.path().string());
        ASSERT_TRUE(reading.model) << entry.path();
        for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle}) {
            SCOPED_TRACE(entry.path());
            ConformOptions options{.mode = mode};
            options.limits.states = 200;  // an automaton may have many thousands of states
            const auto automaton = automaton_of(*reading.model, {0}, options, reading.diagnostics);
            const auto machine = mealy_of(*reading.model, {0}, options, reading.diagnostics);
            if (automaton) shown(diagram(*automaton));
            if (machine) shown(diagram(*machine));
            drawn += (automaton ? 1 : 0) + (machine ? 1 : 0);
        }
    }
    EXPECT_GE(drawn, 12);
}

TEST(DiagramSvg, ComponentsOfTheLibraryAreDrawn) {
    std::size_t drawn = 0;
    for (const auto& entry : std::filesystem::directory_iterator(GRAFVERIF_SOURCE_DIR "/templates")) {
        if (entry.path().extension() != ".grafcet") continue;
        const ParseResult reading = read_file(entry.path().string());
        ASSERT_TRUE(reading.model) << entry.path();
        for (const Component& component : reading.model->components) {
            SCOPED_TRACE(component.name);
            const Shown found = shown(diagram(component));
            EXPECT_EQ(found.arrows, component.edges.size());
            ++drawn;
        }
    }
    EXPECT_GE(drawn, 25u);
}

TEST(DiagramSvg, AComponentShowsItsInvariantsGuardsAndAssignments) {
    const ParseResult reading = read_string(
        "component door(input OPEN; output WIDE: int 0..3; WIDE_max = 3, STEP = 2s) { clock t;\n"
        "initial location shut; location moves invariant t <= STEP; location lost;\n"
        "urgent shut -> moves when OPEN do t := 0;\n"
        "timed moves -> shut when OPEN && t == STEP && WIDE < WIDE_max do WIDE := WIDE + 1;\n"
        "timed lost -> shut; }\n",
        "door.grafcet");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    const Diagram drawn = diagram(*reading.model->components.begin());
    ASSERT_EQ(drawn.nodes.size(), 3u) << "unreachable locations are also drawn";
    EXPECT_EQ(drawn.nodes[1].lines, (std::vector<std::string>{"moves", "t <= STEP"}));
    EXPECT_TRUE(drawn.nodes[0].initial);
    EXPECT_EQ(drawn.arrows[0].lines, (std::vector<std::string>{"urgent, when OPEN", "do t := 0"}));
    EXPECT_EQ(drawn.arrows[1].lines,
              (std::vector<std::string>{"timed, when OPEN && WIDE < WIDE_max && t == STEP", "do WIDE := WIDE + 1"}));
    EXPECT_EQ(drawn.arrows[2].lines, (std::vector<std::string>{"timed"}));
    shown(drawn);
    std::ostringstream out;
    emit_svg(drawn, out, "a-");
    EXPECT_NE(out.str().find("<marker id=\"a-tip\""), std::string::npos);
    EXPECT_NE(out.str().find("url(#a-tip)"), std::string::npos);
}

TEST(DiagramSvg, MoreLocationsThanCanBeReadAreATable) {
    std::mt19937 random(1);
    Diagram diagram = random_diagram(random, 20);
    while (diagram.nodes.size() <= largest_drawing) diagram.nodes.push_back({{"{1}"}, false});
    diagram.arrows.push_back({60, 7, {"a and b"}, false});
    const Shown table = shown(diagram);
    EXPECT_EQ(table.arrows, 0u);
    EXPECT_NE(table.labels.find("to 7: a and b"), std::string::npos);
}

TEST(DiagramSvg, EqualDiagramsGiveEqualBytes) {
    std::mt19937 random(3), again(3);
    std::ostringstream once, twice;
    emit_svg(random_diagram(random, 30), once);
    emit_svg(random_diagram(again, 30), twice);
    EXPECT_EQ(once.str(), twice.str());
}

TEST(DiagramSvg, HostileTextStaysText) {
    const Diagram diagram{"x", {{{"<script>&\"'"}, true}}, {{0, 0, {"</svg>"}, false}}};
    shown(diagram);
}

}  // namespace
}  // namespace grafverif
