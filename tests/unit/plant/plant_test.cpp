// SPDX-License-Identifier: MIT
#include "plant/plant.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "plant/time_unit.hpp"
#include "support/component_builder.hpp"
#include "support/naive_tadd.hpp"
#include "support/print_network.hpp"

namespace grafverif {
namespace {

using ParameterKind = Component::ParameterKind;
using ValueKind = Component::ValueKind;

/// Returns a component that moves X out by D every STEP while G is true. The last step is limited to the end of the
/// range. The component counts its strokes.
Component cylinder() {
    ComponentBuilder build{{.name = "cylinder"}};
    Exprs& exprs = build.component.exprs;
    const Id<Expr> order = build.parameter("G", ParameterKind::Input);
    const Id<Expr> x = build.parameter("X", ParameterKind::Output, ValueKind::Integer);
    const Id<Expr> length = build.parameter("LENGTH", ParameterKind::Constant, ValueKind::Integer);
    const Id<Expr> d = build.parameter("D", ParameterKind::Constant, ValueKind::Integer);
    const Id<Expr> step = build.parameter("STEP", ParameterKind::Constant, ValueKind::Duration);
    build.component.parameters[{1}].low = exprs.integer(0);
    build.component.parameters[{1}].high = length;
    build.component.variables.add(
        {.name = "strokes", .value = ValueKind::Integer, .low = exprs.integer(0), .high = length, .initial = d});
    const auto t = build.component.clocks.add({.name = "t"});
    const auto still = build.location("still"), out = build.location("out");
    build.component.initial = still;
    build.component.locations[out].invariant.push_back({t, Op::LessEqual, step, {}});
    const Id<Expr> next = exprs.apply(Op::Plus, x, d);
    build.edge(still, out, true, exprs.conjunction(order, exprs.apply(Op::Less, x, length))).resets.push_back(t);
    Component::Edge& move = build.edge(out, out, false, exprs.apply(Op::Less, next, length));
    move.constraint.push_back({t, Op::Equal, step, {}});
    move.assignments.push_back({x, next, {}});
    move.resets.push_back(t);
    Component::Edge& end = build.edge(out, still, false, exprs.apply(Op::GreaterEqual, next, length));
    end.constraint.push_back({t, Op::Equal, step, {}});
    end.assignments.push_back({x, length, {}});
    build.edge(out, still, true, exprs.negation(order));
    return std::move(build.component);
}

/// Returns a component whose MID is true while LOW <= X <= HIGH. The component starts in `mid` with MID true, or in
/// `off`.
Component sensor() {
    ComponentBuilder build{{.name = "sensor"}};
    Exprs& exprs = build.component.exprs;
    const Id<Expr> x = build.parameter("X", ParameterKind::Input, ValueKind::Integer);
    const Id<Expr> mid = build.parameter("MID", ParameterKind::Output);
    const Id<Expr> low = build.parameter("LOW", ParameterKind::Constant, ValueKind::Integer);
    const Id<Expr> high = build.parameter("HIGH", ParameterKind::Constant, ValueKind::Integer);
    const auto off = build.location("off"), on = build.location("on");
    build.component.locations[on].initially.push_back({mid, exprs.constant(true), {}});
    const Id<Expr> inside =
        exprs.conjunction(exprs.apply(Op::GreaterEqual, x, low), exprs.apply(Op::LessEqual, x, high));
    build.edge(off, on, true, inside).assignments.push_back({mid, exprs.constant(true), {}});
    build.edge(on, off, true, exprs.negation(inside)).assignments.push_back({mid, exprs.constant(false), {}});
    return std::move(build.component);
}

/// Two cylinders of different length, and a sensor on the first cylinder.
struct Station {
    Model model = {};
    ClosedLoop loop = {};
    Diagnostics diagnostics = {};
    Id<Component> cylinders = model.components.add(cylinder());
    Id<Component> sensors = model.components.add(sensor());

    Station() {
        loop.name = "station";
        const auto h_order = shared("H_G", {}), h = shared("H", integer_type(0, 20)), h_mid = shared("H_MID", {});
        const auto v_order = shared("V_G", {}), v = shared("V", integer_type(0, 10));
        instance("H_Act", cylinders, {h_order, h, std::int64_t{20}, std::int64_t{2}, std::int64_t{1000}}, 0);
        instance("V_Act", cylinders, {v_order, v, std::int64_t{10}, std::int64_t{1}, std::int64_t{1500}}, 0);
        instance("H_Sen", sensors, {h, h_mid, std::int64_t{9}, std::int64_t{11}}, 0);
    }
    Id<ClosedLoop::Shared> shared(const char* name, Type type) { return loop.shared.add({.name = name, .type = type}); }
    void instance(const char* name, Id<Component> component, std::vector<ClosedLoop::Argument> arguments,
                  std::uint32_t initial) {
        loop.instances.add(
            {.name = name, .component = component, .arguments = std::move(arguments), .initial = {initial}});
    }
    ClosedLoop::Instance& operator[](std::uint32_t k) { return loop.instances[{k}]; }
    std::optional<Network> build() { return plant(model, loop, diagnostics); }
    std::string codes() const {
        std::string text;
        for (const Diagnostic& diagnostic : diagnostics.all()) text += (text.empty() ? "" : " ") + diagnostic.code;
        return text;
    }
};

TEST(Plant, OneTemplatePerComponentAndOneProcessPerInstance) {
    Station station;
    const auto network = station.build();
    ASSERT_TRUE(network);
    EXPECT_EQ(station.codes(), "");
    EXPECT_EQ(verify(*network), std::vector<std::string>{});
    EXPECT_EQ(network_text(*network),
              "network station\n"
              "grain phased\n"
              "time unit 500ms\n"
              "\n"
              "plant H_G: bool = false\n"
              "plant H: int 0..20 = 0\n"
              "plant H_MID: bool = false\n"
              "plant V_G: bool = false\n"
              "plant V: int 0..20 = 0\n"
              "plant H_Act_strokes: int 0..20 = 2\n"
              "plant V_Act_strokes: int 0..20 = 1\n"
              "\n"
              "template cylinder\n"
              "    read G: bool\n"
              "    written X: int 0..20\n"
              "    constant LENGTH: int -32768..32767\n"
              "    constant D: int -32768..32767\n"
              "    constant STEP: int -32768..32767\n"
              "    written strokes: int 0..20\n"
              "    clock t\n"
              "    initial location still\n"
              "    location out invariant t <= STEP\n"
              "    urgent still -> out when G && X < LENGTH do t := 0\n"
              "    timed out -> out when X + D < LENGTH && t == STEP do X := X + D, t := 0\n"
              "    timed out -> still when X + D >= LENGTH && t == STEP do X := LENGTH\n"
              "    urgent out -> still when !G\n"
              "\n"
              "template sensor\n"
              "    read X: int 0..20\n"
              "    written MID: bool\n"
              "    constant LOW: int -32768..32767\n"
              "    constant HIGH: int -32768..32767\n"
              "    initial location off\n"
              "    location on\n"
              "    urgent off -> on when X >= LOW && X <= HIGH do MID := true\n"
              "    urgent on -> off when !(X >= LOW && X <= HIGH) do MID := false\n"
              "\n"
              "plant H_Act = cylinder(G = H_G, X = H, LENGTH = 20, D = 2, STEP = 2, strokes = H_Act_strokes) initially "
              "still\n"
              "plant V_Act = cylinder(G = V_G, X = V, LENGTH = 10, D = 1, STEP = 3, strokes = V_Act_strokes) initially "
              "still\n"
              "plant H_Sen = sensor(X = H, MID = H_MID, LOW = 9, HIGH = 11) initially off\n");
}

TEST(Plant, TheTimeUnitIsTheGreatestCommonDivisorOfAllDurations) {
    struct Case {
        std::int64_t first, second, chart, unit;
    };
    for (const Case& c : {Case{1000, 1500, 0, 500}, Case{3000, 6000, 0, 3000}, Case{3000, 6000, 2000, 1000},
                          Case{0, 0, 0, 1000}, Case{250, 1000, 0, 250}}) {
        SCOPED_TRACE(c.unit);
        Station station;
        station[0].arguments[4] = c.first;
        station[1].arguments[4] = c.second;
        Chart chart;
        if (c.chart != 0) chart.time_conditions.add({c.chart, chart.exprs.leaf(Op::Step, 0), 0, {}});
        station.loop.controllers.add({.name = "chart", .chart = station.model.charts.add(chart)});
        const auto network = station.build();
        ASSERT_TRUE(network);
        EXPECT_EQ(network->time_unit_ms, c.unit);
    }
}

TEST(Plant, ANamedTimeUnitDividesEveryDuration) {
    Station station;
    station.loop.time_unit_ms = 100;
    EXPECT_EQ(station.build().value().time_unit_ms, 100);
    station.loop.time_unit_ms = 1000;
    EXPECT_FALSE(station.build());
    EXPECT_EQ(station.codes(), "no-multiple-of-time-unit");
}

TEST(Plant, TheDurationThatMakesTheUnitFineIsFound) {
    struct Case {
        std::int64_t first, second, chart, duration, coarser;
    };
    for (const Case& c : {Case{1000, 1500, 1000, 1000, 1500}, Case{3000, 6000, 2000, 2000, 3000},
                          Case{200, 1000, 990, 990, 200}, Case{1000, 2000, 3000, 0, 0}}) {
        SCOPED_TRACE(c.duration);
        Station station;
        station[0].arguments[4] = c.first;
        station[1].arguments[4] = c.second;
        Chart chart;
        chart.time_conditions.add({c.chart, chart.exprs.leaf(Op::Step, 0), 0, {}});
        station.loop.controllers.add({.name = "chart", .chart = station.model.charts.add(chart)});
        const auto found = finest_duration(station.model, station.loop);
        ASSERT_EQ(found.has_value(), c.duration != 0);
        if (!found) continue;
        EXPECT_EQ(found->duration_ms, c.duration);
        EXPECT_EQ(found->coarser_ms, c.coarser);
        EXPECT_EQ(found->unit_ms, station.build().value().time_unit_ms);
        // If the finest duration is replaced by `coarser_ms`, the time unit must be `coarser_ms`.
        for (const std::uint32_t cylinder : {0U, 1U})
            if (std::get<std::int64_t>(station[cylinder].arguments[4]) == c.duration)
                station[cylinder].arguments[4] = c.coarser;
        for (Chart::TimeCondition& condition :
             station.model.charts[station.loop.controllers[{0}].chart].time_conditions)
            if (condition.rise_ms == c.duration) condition.rise_ms = c.coarser;
        EXPECT_EQ(station.build().value().time_unit_ms, c.coarser);
    }
}

TEST(Plant, AUnitNamedFinerThanTheDurationsAskIsFound) {
    Station station;
    const std::int64_t unit = station.build().value().time_unit_ms;
    station.loop.time_unit_ms = unit / 10;
    const auto found = finest_duration(station.model, station.loop);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->duration_ms, 0);
    EXPECT_EQ(found->unit_ms, unit / 10);
    EXPECT_EQ(found->coarser_ms, unit);
}

TEST(Plant, DurationsOfVeryManyUnitsCauseAWarningThenAnError) {
    Station station;
    station[0].arguments[4] = std::int64_t{10'001};
    station[1].arguments[4] = std::int64_t{1};
    EXPECT_TRUE(station.build());
    EXPECT_EQ(station.codes(), "many-time-units");
    station[0].arguments[4] = std::int64_t{2'000'000'001};
    EXPECT_FALSE(station.build());
    EXPECT_EQ(station.codes(), "many-time-units duration-too-long");
}

TEST(Plant, TheInitialLocationGivesTheFirstValues) {
    Station station;
    station[2].initial = {1};
    const auto network = station.build();
    ASSERT_TRUE(network);
    EXPECT_EQ(network->variables[{2}].name, "H_MID");
    EXPECT_EQ(network->variables[{2}].initial, 1);
    EXPECT_EQ(network->processes[{2}].initial.index, 1U);
}

TEST(Plant, EachFaultHasItsCode) {
    struct Case {
        const char* codes;
        std::function<void(Station&)> damage;
    };
    const auto component = [](Station& s, std::uint32_t k) -> Component& { return s.model.components[{k}]; };
    const std::vector<Case> cases{
        {"two-writers", [](Station& s) { s[1].arguments[1] = Id<ClosedLoop::Shared>{1}; }},
        {"initial-out-of-range", [](Station& s) { s[0].arguments[3] = std::int64_t{21}; }},
        {"bad-range",
         [](Station& s) {
             s[1].arguments[2] = std::int64_t{-1};
             s.loop.shared[{4}].type = integer_type(-1, 10);
         }},
        {"no-value",
         [&](Station& s) {
             Component& c = component(s, 0);
             c.variables[{0}].initial = c.exprs.apply(Op::Divide, c.exprs.integer(1), c.exprs.integer(0));
             s.loop.instances = {};
             s.instance("H_Act", {0},
                        {Id<ClosedLoop::Shared>{0}, Id<ClosedLoop::Shared>{1}, std::int64_t{20}, std::int64_t{2},
                         std::int64_t{1000}},
                        0);
         }},
        {"urgent-invariant", [&](Station& s) { component(s, 0).edges[{0}].resets.clear(); }},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.codes);
        Station station;
        c.damage(station);
        EXPECT_FALSE(station.build());
        EXPECT_NE((" " + station.codes() + " ").find(std::string(" ") + c.codes + " "), std::string::npos)
            << station.codes();
    }
}

TEST(Plant, BothWritersAreNamed) {
    Station station;
    station[1].arguments[1] = Id<ClosedLoop::Shared>{1};
    EXPECT_FALSE(station.build());
    ASSERT_FALSE(station.diagnostics.all().empty());
    EXPECT_EQ(station.diagnostics.all()[0].message,
              "`H` is assigned by `H_Act` and by `V_Act`; assign each shared variable in one place only");
}

TEST(Plant, AStepThatCanJumpOverARangeIsWarnedOf) {
    struct Case {
        std::int64_t step, low, high;
        bool warned;
    };
    for (const Case& c : {Case{2, 9, 11, false}, Case{3, 9, 11, false}, Case{4, 9, 11, true}, Case{2, 9, 9, true},
                          Case{1, 9, 9, false}}) {
        SCOPED_TRACE(std::to_string(c.step) + " over " + std::to_string(c.low) + ".." + std::to_string(c.high));
        Station station;
        station[0].arguments[3] = c.step;
        station[2].arguments[2] = c.low;
        station[2].arguments[3] = c.high;
        EXPECT_TRUE(station.build()) << "it is a warning, not an error";
        EXPECT_EQ(station.codes(), c.warned ? "range-skipped" : "");
    }
}

TEST(Plant, ACylinderMovesStepByStepWhileItIsOrdered) {
    Bench bench(lone_component(cylinder(), {{"LENGTH", 5}, {"D", 2}, {"STEP", 1000}}));
    bench.wait(3);
    EXPECT_EQ(bench.values("X"), std::set<std::int64_t>{0});
    bench.set("G", 1);
    EXPECT_EQ(bench.locations("it"), std::set<std::string>{"out"});
    bench.wait(1);
    EXPECT_EQ(bench.values("X"), std::set<std::int64_t>{2});
    bench.set("G", 0);
    bench.wait(5);
    EXPECT_EQ(bench.values("X"), std::set<std::int64_t>{2});
    bench.set("G", 1);
    bench.wait(2);
    EXPECT_EQ(bench.values("X"), std::set<std::int64_t>{5});
    EXPECT_EQ(bench.locations("it"), std::set<std::string>{"still"});
}

TEST(Plant, DividingTheTimeUnitChangesNoBehaviour) {
    for (const std::int64_t factor : {1, 2, 3}) {
        Station station;
        station.loop.time_unit_ms = 600 / factor;
        station[0].arguments[4] = std::int64_t{600};
        station[1].arguments[4] = std::int64_t{1200};
        Bench bench(station.build().value());
        bench.set("H_G", 1);
        bench.set("V_G", 1);
        bench.wait(5 * factor);
        EXPECT_EQ(bench.values("H"), std::set<std::int64_t>{10});
        EXPECT_EQ(bench.values("H_MID"), std::set<std::int64_t>{1});
        EXPECT_EQ(bench.values("V"), std::set<std::int64_t>{2});
    }
}

}  // namespace
}  // namespace grafverif
