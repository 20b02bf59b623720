// SPDX-License-Identifier: MIT
#include "report/svg.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <pugixml.hpp>
#include <sstream>

#include "traces.hpp"

namespace grafverif {
namespace {

struct Drawn {
    pugi::xml_document document = {};
    pugi::xml_node svg = {};
    double width = 0, height = 0;
};

void draw(const ChartRun& run, Drawn& drawn, EventRange range = {}) {
    std::ostringstream out;
    print_svg(run, "station: P2 <violated>", range, out);
    const auto parsed = drawn.document.load_string(out.str().c_str());
    ASSERT_TRUE(parsed) << parsed.description();
    drawn.svg = drawn.document.child("svg");
    drawn.width = drawn.svg.attribute("width").as_double();
    drawn.height = drawn.svg.attribute("height").as_double();
}

/// Returns the coordinates of a path of M, L, H, V and Z as points.
std::vector<std::pair<double, double>> points(const std::string& path) {
    std::vector<std::pair<double, double>> list;
    std::istringstream in(path);
    double x = 0, y = 0;
    for (char command = 0; in >> command;) {
        if (command == 'M' || command == 'L') in >> x >> y;
        else if (command == 'H') in >> x;
        else if (command == 'V') in >> y;
        else EXPECT_EQ(command, 'Z');
        list.emplace_back(x, y);
    }
    return list;
}

std::vector<pugi::xml_node> of_class(const Drawn& drawn, const std::string& name) {
    std::vector<pugi::xml_node> found;
    for (const pugi::xml_node node : drawn.svg.children())
        if (std::string(node.attribute("class").value()).starts_with(name)) found.push_back(node);
    return found;
}

/// Returns the text below the rows, regardless of line breaks.
std::string foot_of(const Drawn& drawn) {
    std::string words;
    for (const pugi::xml_node line : of_class(drawn, "foot")) words += std::string(" ") + line.text().get();
    return words;
}

TEST(Svg, DrawsEverythingInsideItsSheet) {
    Drawn drawn;
    draw(sample_run(), drawn);
    for (const pugi::xml_node node : drawn.svg.children()) {
        const std::string kind = node.name();
        if (kind == "path")
            for (const auto& [x, y] : points(node.attribute("d").value())) {
                EXPECT_TRUE(0 <= x && x <= drawn.width) << x;
                EXPECT_TRUE(0 <= y && y <= drawn.height) << y;
            }
        if (kind != "rect" && kind != "text") continue;
        EXPECT_LE(node.attribute("x").as_double() + node.attribute("width").as_double(), drawn.width);
        EXPECT_LE(node.attribute("y").as_double() + node.attribute("height").as_double(), drawn.height);
    }
}

TEST(Svg, DrawsAWavePerSignalThatIsEverNotZeroAndNamesTheOthers) {
    Drawn drawn;
    draw(sample_run(), drawn);
    std::vector<std::string> names;
    for (const pugi::xml_node node : of_class(drawn, "name")) names.push_back(node.text().get());
    EXPECT_EQ(names, (std::vector<std::string>{"START", "LEVEL", "GO", "COUNT", "X", "0", "1", "2"}));
    EXPECT_NE(foot_of(drawn).find(" 0 throughout: IDLE"), std::string::npos);
}

TEST(Svg, EveryWaveRunsFromTheFirstColumnToTheLastWithoutGaps) {
    Drawn drawn;
    draw(sample_run(), drawn);
    std::map<double, std::pair<double, double>> reach;  // first and last coordinate of each row
    const auto names = of_class(drawn, "name");
    for (const pugi::xml_node wave : of_class(drawn, "wave")) {
        const auto path = points(wave.attribute("d").value());
        double low = 1e9, high = -1e9, top = 1e9;
        for (const auto& [x, y] : path) low = std::min(low, x), high = std::max(high, x), top = std::min(top, y);
        const double row = std::floor((top - names[0].attribute("y").as_double()) / 26 + 0.5);
        auto [place, added] = reach.try_emplace(row, low, high);
        if (!added) {
            EXPECT_EQ(low, place->second.second) << "a gap";
            place->second.second = high;
        }
    }
    EXPECT_EQ(reach.size(), names.size());
    for (const auto& [row, ends] : reach) EXPECT_EQ(ends, reach.begin()->second);
}

TEST(Svg, ShadesTheLoopAndMarksAdvancesOfTime) {
    Drawn drawn;
    draw(sample_run(), drawn);
    const auto loop = of_class(drawn, "loop");
    ASSERT_EQ(loop.size(), 1u);
    EXPECT_EQ(loop[0].attribute("width").as_int(), 2 * 36);
    const auto rules = of_class(drawn, "rule");
    ASSERT_EQ(rules.size(), 2u);
    EXPECT_EQ(rules[1].attribute("x1").as_double() - rules[0].attribute("x1").as_double(), 3 * 36);
    std::vector<std::string> times;
    for (const pugi::xml_node node : of_class(drawn, "moment")) times.push_back(node.text().get());
    EXPECT_EQ(times, (std::vector<std::string>{"0 s", "1.5 s"}));
    EXPECT_EQ(of_class(drawn, "event").size(), 5u);
    ChartRun finite = sample_run();
    finite.loop_from.reset();
    Drawn other;
    draw(finite, other);
    EXPECT_TRUE(of_class(other, "loop").empty());
}

TEST(Svg, StatesThatColumnsAreEventsAndNumbersThem) {
    Drawn drawn;
    draw(sample_run(), drawn);
    std::vector<std::string> numbers;
    for (const pugi::xml_node node : of_class(drawn, "number")) numbers.push_back(node.text().get());
    EXPECT_EQ(numbers, (std::vector<std::string>{"0", "1", "2", "3", "4"}));
    EXPECT_STREQ(of_class(drawn, "time")[0].text().get(), "event");
    EXPECT_NE(foot_of(drawn).find("Columns are events"), std::string::npos);
}

TEST(Svg, DrawsTheRequestedEventsAndNamesThem) {
    Drawn drawn;
    draw(sample_run(), drawn, {1, 3});
    std::vector<std::string> numbers;
    for (const pugi::xml_node node : of_class(drawn, "number")) numbers.push_back(node.text().get());
    EXPECT_EQ(numbers, (std::vector<std::string>{"1", "2", "3"}));
    EXPECT_NE(foot_of(drawn).find("Events 1 to 3 of 4."), std::string::npos);
    ASSERT_EQ(of_class(drawn, "loop").size(), 1u) << "event 3 is in the loop";
    EXPECT_EQ(of_class(drawn, "loop")[0].attribute("width").as_int(), 36);
    Drawn after_end;
    draw(sample_run(), after_end, {99, 100});
    EXPECT_EQ(of_class(after_end, "number").size(), 1u) << "the last event is drawn";
}

TEST(Svg, CutsALongTraceIntoStripsThatNameTheirRows) {
    ChartRun run = sample_run();
    run.loop = run.loop_from = {};
    for (std::size_t k = 0; k < 95; ++k) {
        ChartRun::Event moment = run.moments.back();
        moment.after.time_ms += 100;
        moment.after.values[0] = static_cast<std::int64_t>(k % 2);
        run.moments.push_back(moment);
        run.rows.push_back({.kind = ChartRun::Kind::Plant, .component = "Slide", .moment = run.moments.size() - 1});
    }
    Drawn drawn;
    draw(run, drawn);
    ASSERT_EQ(of_class(drawn, "number").size(), 99u) << "the next row shows the time after a delay";
    EXPECT_STREQ(of_class(drawn, "number").back().text().get(), "98") << "a delay has no number";
    std::map<double, int> starts;
    for (const pugi::xml_node name : of_class(drawn, "name"))
        if (std::string(name.text().get()) == "START") ++starts[name.attribute("y").as_double()];
    EXPECT_EQ(starts.size(), 3u);
    EXPECT_LT(drawn.width, 2000);
    double last = 0;
    for (const pugi::xml_node number : of_class(drawn, "number"))
        last = std::max(last, number.attribute("x").as_double());
    EXPECT_LT(last, drawn.width);
}

}  // namespace
}  // namespace grafverif
