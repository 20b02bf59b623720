// SPDX-License-Identifier: MIT
// Randomized test of drawings: no elements overlap, and the drawing contains each element of the chart exactly once.
#include <gtest/gtest.h>

#include <algorithm>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "draw/chart.hpp"
#include "draw/svg.hpp"
#include "support/drawing_faults.hpp"
#include "support/random_chart.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

/// Returns a chart whose steps and transitions are connected arbitrarily, unlike those of any practical chart.
Chart tangle(Random& random) {
    Chart chart{.name = "tangle"};
    const auto partial = chart.partial_charts.add({});
    const auto steps = static_cast<std::uint32_t>(random_number(random, 1, 14));
    for (std::uint32_t k = 0; k < steps; ++k)
        chart.steps.add({.name = std::to_string(k), .initial = chance(random, 20), .chart = partial});
    const auto some = [&](int most) {
        std::set<std::uint32_t> picked;
        for (std::int64_t k = random_number(random, 0, most); k > 0; --k)
            picked.insert(static_cast<std::uint32_t>(random_number(random, 0, steps - 1)));
        std::vector<Id<Chart::Step>> ids;
        for (const std::uint32_t index : picked) ids.push_back({index});
        return ids;
    };
    for (std::int64_t k = random_number(random, 0, 20); k > 0; --k)
        chart.transitions.add({.name = "t" + std::to_string(k),
                               .from = some(3),
                               .to = some(3),
                               .condition = chart.exprs.constant(true),
                               .chart = partial});
    return chart;
}

/// Returns a ring of `steps` steps with some links back and some links that skip steps.
Chart long_ring(std::uint32_t steps, Random& random) {
    Chart chart{.name = "ring"};
    const auto partial = chart.partial_charts.add({});
    for (std::uint32_t k = 0; k < steps; ++k)
        chart.steps.add({.name = std::to_string(k), .initial = k == 0, .chart = partial});
    const auto link = [&](std::uint32_t from, std::uint32_t to) {
        chart.transitions.add({.name = "t" + std::to_string(chart.transitions.size()),
                               .from = {{from}},
                               .to = {{to}},
                               .condition = chart.exprs.constant(true),
                               .chart = partial});
    };
    for (std::uint32_t k = 0; k < steps; ++k) {
        link(k, (k + 1) % steps);
        if (chance(random, 5)) link(k, k - static_cast<std::uint32_t>(random_number(random, 0, std::min(k, 9U))));
        if (chance(random, 5))
            link(k, std::min(steps - 1, k + static_cast<std::uint32_t>(random_number(random, 2, 9))));
    }
    return chart;
}

std::string svg_of(const Drawing& drawing) {
    std::ostringstream out;
    draw::print_svg(drawing, out);
    return std::move(out).str();
}

/// The ids and links of a chart, each as often as it must be drawn.
struct Content {
    std::multiset<std::string> ids = {};
    std::multiset<std::pair<std::string, std::string>> links = {};
    bool operator==(const Content&) const = default;
};

Content content_of(const Chart& chart) {
    const ElementIds ids = element_ids(chart);
    Content content;
    for (const auto* list : {&ids.steps, &ids.transitions, &ids.conditions, &ids.continuous, &ids.stored, &ids.forcing})
        content.ids.insert(list->begin(), list->end());
    std::set<std::size_t> filled;
    for (const Chart::Step& step : chart.steps) filled.insert(step.chart.index);
    for (const Chart::Transition& transition : chart.transitions) filled.insert(transition.chart.index);
    for (const std::size_t partial : filled) content.ids.insert(ids.partial_charts[partial]);
    for (const auto id : chart.transitions.ids()) {
        for (const auto step : chart.transitions[id].from)
            content.links.emplace(ids.steps[step.index], ids.transitions[id.index]);
        for (const auto step : chart.transitions[id].to)
            content.links.emplace(ids.transitions[id.index], ids.steps[step.index]);
    }
    return content;
}

Content read_back(const std::string& svg) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(svg.c_str()));
    Content content;
    for (const pugi::xml_node group : document.child("svg").children("g")) {
        if (group.attribute("id")) content.ids.insert(group.attribute("id").value());
        if (std::string_view(group.attribute("class").value()).starts_with("link"))
            content.links.emplace(group.attribute("data-from").value(), group.attribute("data-to").value());
    }
    return content;
}

void expect_good(const Chart& chart, const DrawOptions& options, const std::string& what) {
    const Drawing drawing = draw::drawing_of(chart, options);
    const std::vector<std::string> found = faults(drawing);
    const std::string svg = svg_of(drawing);
    EXPECT_EQ(found, std::vector<std::string>()) << what << "\n\n" << svg;
    EXPECT_EQ(read_back(svg), content_of(chart)) << what;
    EXPECT_EQ(svg_of(draw::drawing_of(chart, options)), svg) << what;
}

DrawOptions random_options(const Chart& chart, Random& random) {
    DrawOptions options{.notation = chance(random, 50) ? Notation::Iec : Notation::Text,
                        .columns = static_cast<int>(random_number(random, 0, 4))};
    for (const auto step : chart.steps.ids())
        if (chance(random, 30)) options.situation.push_back(step);
    return options;
}

TEST(RandomizedDrawing, ChartsOfEveryElementAreDrawnCompletelyWithoutOverlaps) {
    for (int seed = 1; seed <= test_size(300) && !testing::Test::HasFailure(); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Chart chart = random_chart(random);
        expect_good(chart, random_options(chart, random), "seed " + std::to_string(seed));
    }
}

TEST(RandomizedDrawing, ArbitrarilyConnectedChartsAreDrawnWithoutOverlaps) {
    for (int seed = 1; seed <= test_size(600) && !testing::Test::HasFailure(); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Chart chart = tangle(random);
        expect_good(chart, random_options(chart, random), "seed " + std::to_string(seed));
    }
}

TEST(RandomizedDrawing, LongFoldedRingsAreDrawnWithoutOverlaps) {
    for (int seed = 1; seed <= test_size(10) && !testing::Test::HasFailure(); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Chart chart = long_ring(400, random);
        expect_good(chart, {}, "seed " + std::to_string(seed));
    }
}

}  // namespace
}  // namespace grafverif
