// SPDX-License-Identifier: MIT
// Tests timers in transient situations with the pulse chart, and shows the behaviour of this chart with the timers of
// the published method.
#include <gtest/gtest.h>

#include "hand_chart.hpp"
#include "support/naive_tadd.hpp"

namespace grafverif {
namespace {

/// Returns a chart with the transitions 1 -> 2 when 5s/X1 and 2 -> 1 when true, which generates one
/// pulse every 5 s.
Model pulse() {
    HandChart hand("pulse");
    const auto one = hand.step("1", true), two = hand.step("2");
    hand.transition(one, two, hand.after(5000, one));
    hand.transition(two, one, hand.always());
    return lone_controller(hand.chart);
}

struct History {
    int pulses = 0;
    int units = 0;  ///< number of time units that passed
};

/// Runs the network until `units` have passed or `most_edges` are taken; edges are taken before time passes. Counts the
/// activations of step 2.
History run(const Network& network, int units, int most_edges) {
    const NaiveTadd tadd(network);
    TaddState state = tadd.initial();
    History result;
    for (int edges = 0; edges < most_edges && result.units < units; ++edges) {
        const std::int64_t before = tadd.variable(state, "X_2");
        const std::vector<TaddMove> moves = tadd.successors(state);
        if (moves.empty()) break;
        result.units += moves.front().delay();
        state = moves.front().next;
        result.pulses += before == 0 && tadd.variable(state, "X_2") == 1;
    }
    return result;
}

TEST(Timers, ThePulseChartFiresOncePerFiveSecondsInBothGrainsAndModes) {
    for (const Grain grain : {Grain::Phased, Grain::Atomic}) {
        for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle}) {
            const Network network = composed(pulse(), {grain, mode, {}});
            EXPECT_EQ(network.time_unit_ms, 5000);
            const History result = run(network, 6, 1000);
            EXPECT_EQ(result.units, 6);
            EXPECT_EQ(result.pulses, 6 - 1) << "the pulse at the sixth unit has not occurred yet";
        }
    }
}

TEST(Timers, PublishedPulseChartFiresForeverInOneInstant) {
    const Network network = composed(pulse(), {.ablations = {.timers_as_published = true}});
    const History result = run(network, 6, 1000);
    EXPECT_LE(result.units, 2) << "time does not pass after the first five seconds";
    EXPECT_GT(result.pulses, 50);
}

TEST(Timers, AStepThatIsLeftInTimeNeverEndsItsTimer) {
    HandChart hand("watch");
    const auto a = hand.input("a");
    const auto one = hand.step("1", true), two = hand.step("2"), late = hand.step("late");
    hand.transition(one, late, hand.after(3000, one));
    hand.transition(one, two, hand.leaf(a));
    hand.transition(two, one, hand.chart.exprs.negation(hand.leaf(a)));
    hand.transition(two, two, hand.chart.exprs.conjunction(hand.after(1000, two), hand.never()));
    const Network network = composed(lone_controller(hand.chart));
    ASSERT_EQ(network.time_unit_ms, 1000);
    Bench bench(network);
    const auto press = [&](std::int64_t value) {
        bench.set("EVOL_PL", 1);  // an edge of a plant would set this flag together with the input
        bench.set("a", value);
        bench.set("EVOL_PL", 1);
    };
    for (int round = 0; round < 4; ++round) {
        bench.wait(2);
        press(1);
        EXPECT_EQ(bench.values("X_2"), std::set<std::int64_t>{1});
        press(0);
        EXPECT_EQ(bench.values("X_1"), std::set<std::int64_t>{1});
    }
    EXPECT_EQ(bench.values("X_late"), std::set<std::int64_t>{0});
    bench.wait(3);
    EXPECT_EQ(bench.values("X_late"), std::set<std::int64_t>{1});
}

TEST(Timers, TimePassesWhileTheControllerWaits) {
    const Network network = composed(pulse());
    const NaiveTadd tadd(network);
    for (const TaddState& state : reachable(network, 10000).states) {
        const bool waits = tadd.location(state, "PLC") == "W";
        const std::vector<TaddMove> moves = tadd.successors(state);
        ASSERT_FALSE(moves.empty());
        const bool elapsed = state.clocks[0] == 1;
        if (tadd.settled(state) && !elapsed) {
            EXPECT_TRUE(moves.back().delay());
        }
        if (!waits) {
            EXPECT_FALSE(moves.back().delay()) << "a cycle takes no time";
        }
    }
}

}  // namespace
}  // namespace grafverif
