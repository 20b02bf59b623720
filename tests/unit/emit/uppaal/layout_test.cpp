// SPDX-License-Identifier: MIT
// Tests that locations, names and labels do not overlap in the drawings of a project.
#include <gtest/gtest.h>

#include <map>
#include <pugixml.hpp>
#include <sstream>

#include "emit/uppaal/uppaal.hpp"
#include "support/random_network.hpp"
#include "support/test_size.hpp"
#include "unit/emit/uppaal/drawings.hpp"
#include "unit/emit/uppaal/hand_networks.hpp"
#include "unit/emit/uppaal/project_text.hpp"

namespace grafverif {
namespace {

using test::overlaps;

TEST(UppaalLayout, ElementsDoNotOverlap) {
    EXPECT_EQ(overlaps(test::project(test::station())), "");
    EXPECT_EQ(overlaps(test::project(test::awkward_names())), "");
    EXPECT_EQ(overlaps(test::project(test::crowded())), "");
}

TEST(UppaalLayout, ElementsDoNotOverlapInAnyNetwork) {
    for (int seed = 0; seed < test_size(150); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        EXPECT_EQ(overlaps(test::project(random_network(random))), "") << "seed " << seed;
    }
}

// Tests the overlap check itself.
TEST(UppaalLayout, OverlapsAreDetected) {
    const std::string project =
        "<nta><template><name>a</name><location id='i' x='0' y='0'><name x='20' y='0'>w</name></location>"
        "<location id='j' x='%' y='0'/></template></nta>";
    const auto with = [&](const std::string& x) { return std::string(project).replace(project.find('%'), 1, x); };
    EXPECT_NE(overlaps(with("10")), "");
    EXPECT_NE(overlaps(with("30")), "");
    EXPECT_EQ(overlaps(with("60")), "");
}

pugi::xml_node template_named(const pugi::xml_document& document, const std::string& name) {
    for (const pugi::xml_node node : document.child("nta").children("template"))
        if (name == node.child_value("name")) return node;
    return {};
}

TEST(UppaalLayout, DrawsThePlcCycleAsASquare) {
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(test::project(test::station()).c_str()));
    std::map<std::string, std::pair<int, int>> places;
    for (const pugi::xml_node location : template_named(document, "plc_cycle").children("location"))
        places[location.child_value("name")] = {location.attribute("x").as_int(), location.attribute("y").as_int()};
    EXPECT_EQ(places["W"].second, places["P0"].second);
    EXPECT_EQ(places["P1"].second, places["P2"].second);
    EXPECT_EQ(places["W"].first, places["P2"].first);
    EXPECT_EQ(places["P0"].first, places["P1"].first);
    EXPECT_LT(places["W"].first, places["P0"].first);
    EXPECT_LT(places["W"].second, places["P2"].second);
}

TEST(UppaalLayout, GivesLoopsAndParallelEdgesNails) {
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(test::project(test::crowded()).c_str()));
    for (const pugi::xml_node automaton : document.child("nta").children("template")) {
        std::map<std::pair<std::string, std::string>, int> straight;
        for (const pugi::xml_node edge : automaton.children("transition")) {
            const std::string from = edge.child("source").attribute("ref").value(),
                              to = edge.child("target").attribute("ref").value();
            if (edge.child("nail")) continue;
            EXPECT_NE(from, to);
            EXPECT_EQ(++straight[std::minmax(from, to)], 1) << "two edges coincide";
        }
    }
}

TEST(UppaalLayout, IsTheSameEveryTime) { EXPECT_EQ(test::project(test::crowded()), test::project(test::crowded())); }

/// Returns a template of `locations` locations in a circle, each with a loop.
Network wheel(std::uint32_t locations) {
    test::Hand h;
    h.network.name = "wheel";
    Network::Template automaton{.name = "wheel"};
    for (std::uint32_t i = 0; i < locations; ++i) automaton.locations.add({"l" + std::to_string(i), {}, {}});
    automaton.initial = {0};
    for (std::uint32_t i = 0; i < locations; ++i)
        for (const std::uint32_t to : {i, (i + 1) % locations})
            automaton.edges.add({.from = {i}, .to = {to}, .urgent = true, .guard = h.yes()});
    h.process("p", h.network.templates.add(std::move(automaton)), {}, Network::ProcessKind::Plant);
    return h.network;
}

/// Returns a template of a hub and `leaves` locations that are connected only to the hub.
Network star(std::uint32_t leaves) {
    test::Hand h;
    h.network.name = "star";
    Network::Template automaton{.name = "star"};
    for (std::uint32_t i = 0; i <= leaves; ++i) automaton.locations.add({"l" + std::to_string(i), {}, {}});
    automaton.initial = {0};
    for (std::uint32_t i = 1; i <= leaves; ++i)
        automaton.edges.add({.from = {0}, .to = {i}, .urgent = true, .guard = h.yes()});
    h.process("p", h.network.templates.add(std::move(automaton)), {}, Network::ProcessKind::Plant);
    return h.network;
}

TEST(UppaalLayout, PlacesManyLeaves) {
    for (const std::uint32_t leaves : {3U, 4U, 7U, 20U, 59U, 200U})
        EXPECT_EQ(overlaps(test::project(star(leaves))), "") << leaves << " leaves";
}

TEST(UppaalLayout, DrawsLargeTemplatesToo) { EXPECT_EQ(overlaps(test::project(wheel(3000))), ""); }

}  // namespace
}  // namespace grafverif
