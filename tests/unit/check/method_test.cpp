// SPDX-License-Identifier: MIT
// Tests the claims of the papers CEP13 and ETFA12 (docs/explanation/method.md) about the method. Each claim is false if
// the corresponding correction is removed from the method.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "support/read_loop.hpp"
#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

constexpr const char* station = "testing_station/testing_station.grafcet";
constexpr const char* oven = "oven_door/oven_door.grafcet";

/// Returns the variable `name` as a term of `network`.
Id<Expr> is(Network& network, const std::string& name) {
    const auto found = std::ranges::find(network.variables, name, &Network::Variable::name);
    if (found == network.variables.end()) throw std::out_of_range("unknown variable " + name);
    return network.exprs.leaf(Op::Variable, static_cast<std::uint32_t>(found - network.variables.begin()));
}

void add_property(Network& network, const std::string& name, Pattern pattern, std::vector<Id<Expr>> operands) {
    network.properties.add({.name = name, .pattern = pattern, .operands = std::move(operands)});
}

Network sample(const std::string& path, const Ablations& ablations = {}, std::optional<Grain> grain = {}) {
    return read_sample(path, {.grain = grain, .ablations = ablations}).network;
}

TEST(Urgency, ASensorOfTheTestingStationIsNeverLate) {
    const auto late = [](Network network) {  // CEP13 Fig. 12b: H = 4 while H_IN is still true
        const Id<Expr> four = network.exprs.apply(Op::Equal, is(network, "H"), network.exprs.integer(4));
        add_property(network, "late", Pattern::Reachable, {network.exprs.conjunction(four, is(network, "H_IN"))});
        return outcome_text(checked(network), "late");
    };
    EXPECT_EQ(late(sample(station)), "violated");
    EXPECT_EQ(late(sample(station, {}, Grain::Atomic)), "violated");
    EXPECT_EQ(late(sample(station, {.sensors_not_urgent = true}, Grain::Atomic)), "holds");
}

TEST(Flags, WithoutThemTimeNeverPassesAndUppaalSeesNoDeadlock) {
    for (const char* path : {station, oven}) {
        SCOPED_TRACE(path);
        const TimedResult cured = checked(sample(path));
        EXPECT_EQ(outcome_text(cured, "no_timelock"), "holds");
        EXPECT_EQ(outcome_text(cured, "no_deadlock"), "holds");
        const TimedResult bare = checked(sample(path, {.cycle_always = true}));
        EXPECT_EQ(outcome_text(bare, "no_timelock"), "violated");
        EXPECT_EQ(outcome_text(bare, "no_deadlock"), "holds, vacuous");
        EXPECT_FALSE(bare.time_passes) << "time cannot pass from the initial state on";
        EXPECT_TRUE(std::ranges::all_of(verdict(bare, "no_timelock").run->moves,
                                        [](const Move& move) { return std::holds_alternative<Fire>(move); }));
    }
}

TEST(Stable, PressInAQuiescentStateAlwaysHasAnEffect) {
    const auto answered = [](Network network) {  // CEP13 Fig. 26 and 27: START is pressed during step 23
        const Id<Expr> pressed = network.exprs.conjunction(is(network, "X_0"), is(network, "START"));
        const Id<Expr> released = network.exprs.negation(pressed);
        add_property(network, "answered", Pattern::LeadsTo, {pressed, released});
        return outcome_text(checked(network), "answered");
    };
    EXPECT_EQ(answered(sample(station)), "holds");
    EXPECT_EQ(answered(sample(station, {.cycle_unless_stable = true})), "violated");
    EXPECT_EQ(answered(read_sample(station, {.mode = ExecutionMode::EveryCycle}).network), "holds")
        << "the mode is not the cause";
}

TEST(Stable, WithoutItTheStationNeedNotComeBackToRest) {
    const TimedResult bare = checked(sample(station, {.cycle_unless_stable = true}));
    EXPECT_EQ(outcome_text(bare, "P15"), "holds");
    EXPECT_EQ(outcome_text(bare, "no_timelock"), "holds");
}

TEST(Timers, PulseChartLetsTimePassWithCorrectedTimersButNotWithThoseOfFigure33b) {
    constexpr const char* pulse = R"(
        component watch(output TOC) {
            clock t;
            initial location ticking invariant t <= 1s;
            timed ticking -> ticking when t == 1s do TOC := !TOC, t := 0;
        }
        grafcet pulse {
            output TICK;
            initial step 1;
            step 2 { TICK; }
            transition t1: 1 -> 2 when 5s/X1;
            transition t2: 2 -> 1 when true;
        }
        closed_loop pulse_loop {
            controller pulse;
            plant Lamp = lamp(ON = TICK);
            environment Watch = watch(TOC = TOC);
            property no_deadlock: no deadlock;
            property time_goes_on: TOC leads to !TOC;
        })";
    for (const Grain grain : {Grain::Phased, Grain::Atomic}) {
        const TimedResult cured = checked(read_loop(pulse, {.grain = grain}).network);
        EXPECT_EQ(outcome_text(cured, "no_timelock"), "holds");
        EXPECT_EQ(outcome_text(cured, "time_goes_on"), "holds");
        const TimedResult bare =
            checked(read_loop(pulse, {.grain = grain, .ablations = {.timers_as_published = true}}).network);
        EXPECT_EQ(outcome_text(bare, "time_goes_on"), "violated");
        EXPECT_EQ(outcome_text(bare, "no_deadlock"), "holds");
        EXPECT_EQ(outcome_text(bare, "no_timelock"), "holds") << "time can pass if the timer reacts early enough";
        const grafverif::Run& run = *verdict(bare, "time_goes_on").run;
        ASSERT_TRUE(run.loop);
        EXPECT_TRUE(std::all_of(run.moves.begin() + static_cast<std::ptrdiff_t>(*run.loop), run.moves.end(),
                                [](const Move& move) { return std::holds_alternative<Fire>(move); }))
            << "the chart clears transitions forever in one instant";
    }
}

/// Returns the faulty station with watchdogs of `seconds`.
Network faulty(const std::string& seconds) {
    std::ifstream file(std::string(GRAFVERIF_SOURCE_DIR) + "/samples/testing_station/faulty.grafcet");
    std::string text{std::istreambuf_iterator<char>(file), {}};
    for (std::size_t at = text.find("12s/X"); at != std::string::npos; at = text.find("12s/X", at + 1))
        text.replace(at, 3, seconds);
    return read_loop(text).network;
}

TEST(Watchdogs, MissAFaultInTheInstantOfArrivalAndNoOther) {
    const TimedResult result = checked(faulty("12s"));
    EXPECT_EQ(outcome_text(result, "P16"), "violated")
        << "it holds according to the publication; see the README of the sample";
    for (const char* property :
         {"P15", "P16_settled", "P16_under_way", "P16_or_rest", "no_false_alarm", "no_deadlock", "no_timelock"})
        EXPECT_EQ(outcome_text(result, property), "holds") << property;
    const Verdict escaped = verdict(result, "P16");
    ASSERT_TRUE(escaped.run->loop);
}

TEST(Watchdogs, ShorterThanAStrokeTheyMakeTheirPropertyHoldByFalseAlarms) {
    const TimedResult result = checked(faulty("5s"));
    EXPECT_EQ(outcome_text(result, "P16"), "holds");
    EXPECT_EQ(outcome_text(result, "no_false_alarm"), "violated");
}

}  // namespace
}  // namespace grafverif
