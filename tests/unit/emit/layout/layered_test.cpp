// SPDX-License-Identifier: MIT
// Tests the rules of layered drawings on graphs of every kind and in both directions.
#include "emit/layout/layered.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "scene.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

using layout::Box;
using layout::Direction;
using layout::Layered;
using layout::Point;
using layout::States;

/// Returns chains, trees and nearly complete graphs, with loops, arrows without target, parallel arrows and unreachable
/// nodes.
States random_states(std::mt19937& random) {
    const auto below = [&random](std::size_t limit) { return random() % limit; };
    States states;
    const std::size_t nodes = 1 + below(24), dense = 1 + below(5);
    for (std::size_t k = 0; k < nodes; ++k)
        states.nodes.push_back({static_cast<int>(20 + below(150)), static_cast<int>(20 + below(40))});
    states.first = below(nodes);
    for (std::size_t k = below(nodes * dense + 1); k > 0; --k) {
        const std::size_t from = below(nodes);
        const std::size_t to = below(3) == 0 ? below(nodes) : (from + 1 + below(3)) % nodes;
        const int lines = static_cast<int>(below(4));
        states.arrows.push_back({from, to, {lines * static_cast<int>(below(120)), lines * 14}, below(12) == 0});
    }
    return states;
}

bool is_on_rim(const Box& box, Point at) {
    const bool x = at.x == box.at.x || at.x == box.at.x + box.size.width;
    const bool y = at.y == box.at.y || at.y == box.at.y + box.size.height;
    const bool is_outside =
        at.x >= box.at.x && at.x <= box.at.x + box.size.width && at.y >= box.at.y && at.y <= box.at.y + box.size.height;
    return is_outside && x != y;
}

Scene scene_of(const States& states, const Layered& drawing) {
    Scene scene{.boxes = drawing.nodes, .lines = {}, .page = {{0, 0}, drawing.size}};
    std::map<std::pair<int, int>, std::size_t> nets;  // lines by their end points
    for (std::size_t k = 0; k < states.arrows.size(); ++k) {
        const std::vector<Point>& points = drawing.arrows[k].points;
        if (states.arrows[k].label.width > 0) scene.boxes.push_back(drawing.arrows[k].label);
        scene.lines.push_back({points, nets.try_emplace({points.back().x, points.back().y}, k).first->second});
    }
    return scene;
}

TEST(RandomizedLayered, NothingOverlapsAndEveryArrowJoinsItsNodes) {
    for (int seed = 1; seed <= test_size(400); ++seed) {
        std::mt19937 random(static_cast<unsigned>(seed));
        const States states = random_states(random);
        for (const Direction direction : {Direction::Across, Direction::Down}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + (direction == Direction::Down ? ", down" : ", across"));
            const Layered drawing = layout::layered(states, direction);
            ASSERT_EQ(faults(scene_of(states, drawing)), std::vector<std::string>{});
            for (std::size_t k = 0; k < states.nodes.size(); ++k) {
                ASSERT_GE(drawing.nodes[k].size.width, states.nodes[k].width);
                ASSERT_GE(drawing.nodes[k].size.height, states.nodes[k].height);
            }
            for (std::size_t k = 0; k < states.arrows.size(); ++k) {
                const std::vector<Point>& points = drawing.arrows[k].points;
                ASSERT_TRUE(is_on_rim(drawing.nodes[states.arrows[k].from], points.front())) << k;
                if (states.arrows[k].ends) continue;
                ASSERT_TRUE(is_on_rim(drawing.nodes[states.arrows[k].to], points.back())) << k;
                ASSERT_GT(points.size(), 1u);
            }
        }
    }
}

/// Each label is next to the first segment of its line, closer to it than to any other line.
TEST(RandomizedLayered, LabelsAreNextToTheirLines) {
    for (int seed = 1; seed <= test_size(100); ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(static_cast<unsigned>(seed));
        const States states = random_states(random);
        for (const Direction direction : {Direction::Across, Direction::Down}) {
            const Layered drawing = layout::layered(states, direction);
            for (std::size_t k = 0; k < states.arrows.size(); ++k) {
                const auto& [points, label] = drawing.arrows[k];
                const int away = direction == Direction::Across ? points[0].y - label.at.y - label.size.height
                                                                : label.at.x - points[0].x;
                EXPECT_GE(away, 0);
                EXPECT_LE(away, 5);
            }
        }
    }
}

TEST(Layered, EqualGraphsGiveEqualDrawings) {
    std::mt19937 random(7), again(7);
    const Layered once = layout::layered(random_states(random), Direction::Down);
    const Layered twice = layout::layered(random_states(again), Direction::Down);
    ASSERT_EQ(once.arrows.size(), twice.arrows.size());
    for (std::size_t k = 0; k < once.arrows.size(); ++k) EXPECT_EQ(once.arrows[k].points, twice.arrows[k].points);
    for (std::size_t k = 0; k < once.nodes.size(); ++k) EXPECT_EQ(once.nodes[k].at, twice.nodes[k].at);
}

TEST(Layered, AChainIsOneStraightLine) {
    States chain;
    for (int k = 0; k < 12; ++k) chain.nodes.push_back({40 + 7 * (k % 5), 28});
    for (std::size_t k = 0; k + 1 < chain.nodes.size(); ++k) chain.arrows.push_back({k, k + 1, {70, 14}});
    for (const Direction direction : {Direction::Across, Direction::Down})
        for (const Layered::Arrow& arrow : layout::layered(chain, direction).arrows) EXPECT_EQ(arrow.points.size(), 2u);
}

TEST(Layered, LayerContainsNodesAtEqualDistanceFromTheFirstNode) {
    States states{.nodes = {{40, 30}, {40, 30}, {40, 30}, {40, 30}},
                  .arrows = {{2, 0, {}}, {2, 3, {}}, {0, 1, {}}, {3, 1, {}}, {1, 2, {}}},
                  .first = 2};
    const Layered drawing = layout::layered(states, Direction::Down);
    EXPECT_LT(drawing.nodes[2].at.y, drawing.nodes[0].at.y);
    EXPECT_EQ(drawing.nodes[0].at.y, drawing.nodes[3].at.y);
    EXPECT_LT(drawing.nodes[0].at.y, drawing.nodes[1].at.y);
}

/// Lines that join have one arrow head, and a dot at their junction.
TEST(Layered, ArrowsToOneNodeMeet) {
    States states{.nodes = {{40, 30}, {40, 30}, {40, 30}, {40, 30}},
                  .arrows = {{0, 1, {50, 14}}, {0, 2, {50, 14}}, {1, 3, {50, 14}}, {2, 3, {50, 14}}},
                  .first = 0};
    const Layered drawing = layout::layered(states, Direction::Down);
    EXPECT_EQ(drawing.arrows[2].points.back(), drawing.arrows[3].points.back());
    EXPECT_FALSE(drawing.arrows[0].points.back() == drawing.arrows[1].points.back());
    EXPECT_EQ(drawing.joints.size(), 1u);
}

TEST(Layered, EmptyGraphGivesAnEmptyDrawing) { EXPECT_TRUE(layout::layered({}, Direction::Across).nodes.empty()); }

}  // namespace
}  // namespace grafverif
