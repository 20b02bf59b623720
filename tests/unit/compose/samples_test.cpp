// SPDX-License-Identifier: MIT
// Tests the published systems of CEP13 and ETFA12 in the reference semantics, with the complete method and without each
// correction.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/naive_tadd.hpp"
#include "support/print_network.hpp"
#include "support/read_loop.hpp"

namespace grafverif {
namespace {

/// The horizontal axis of the testing station. A push button moves it out and back.
constexpr const char* axis = R"(
    grafcet axis {
        input START, H_IN, H_MID, H_OUT;
        output H_G_OUT, H_G_IN;
        initial step 0;
        step 1 { H_G_OUT; }
        step 23 { H_G_IN; }
        transition T0: 0 -> 1 when START;
        transition T1: 1 -> 23 when H_OUT;
        transition T23: 23 -> 0 when H_IN;
    }
    closed_loop axis_loop {
        controller axis with stability_search;
        plant H_Act = cylinder_5_3(G_IN = H_G_IN, G_OUT = H_G_OUT, X = H, X_max = 20, D_X = 2);
        plant H_Sen = position_sensors_3(X = H, IN = H_IN, MID = H_MID, OUT = H_OUT, X_IN_max = 2, X_MID_min = 9,
                                         X_MID_max = 11, X_OUT_min = 18) initially in;
        environment Start = push_button(OUT = START, GAP = 1s);
        property safe: never H_G_OUT && H_G_IN;
    })";

/// Every reachable state of a loop, and functions that query these states.
struct Explored {
    Network network;
    NaiveTadd tadd;
    Reachable all;

    explicit Explored(Network of, std::size_t limit = 100'000)
        : network(std::move(of)), tadd(network), all(reachable(network, limit)) {}
    Explored(const char* text, const ComposeOptions& options) : Explored(read_loop(text, options).network) {}

    template <class Predicate>
    std::size_t count(const Predicate& predicate) const {
        return static_cast<std::size_t>(std::ranges::count_if(all.states, predicate));
    }
    std::int64_t value(const TaddState& state, const char* name) const { return tadd.variable(state, name); }

    /// True if the property, which is `never` or `always`, holds in all states.
    bool holds(const std::string& name) const {
        for (const Property& property : network.properties) {
            if (property.name != name) continue;
            const bool never = property.pattern == Pattern::Never;
            return std::ranges::all_of(all.states, [&](const TaddState& state) {
                const bool is_considered = !property.at_stable || tadd.settled(state);
                return !is_considered || tadd.holds(property.operands[0], state) != never;
            });
        }
        throw std::out_of_range("unknown property " + name);
    }
    bool time_can_pass(const TaddState& state) const {
        const std::vector<TaddMove> moves = tadd.successors(state);
        return !moves.empty() && moves.back().delay();
    }
};

TEST(Urgency, SensorsWithUrgentEdgesAreNeverLate) {
    for (const Grain grain : {Grain::Phased, Grain::Atomic}) {
        const Explored cured(axis, {.grain = grain});
        ASSERT_TRUE(cured.all.complete);
        EXPECT_FALSE(cured.all.out_of_range);
        EXPECT_EQ(cured.count([&](const TaddState& state) {
            return cured.value(state, "H") == 4 && cured.value(state, "H_IN") == 1;
        }),
                  0U);
        EXPECT_TRUE(cured.holds("safe"));
        EXPECT_GT(cured.count([&](const TaddState& state) {
            return cured.value(state, "X_23") == 1 && cured.value(state, "H") == 4;
        }),
                  0U);
    }
}

TEST(Urgency, WithoutItTheStateOfFigure12bIsReached) {
    const Explored bare(axis, {.grain = Grain::Atomic, .ablations = {.sensors_not_urgent = true}});
    EXPECT_GT(bare.count([&](const TaddState& state) {
        return bare.value(state, "H") == 4 && bare.value(state, "H_IN") == 1;
    }),
              0U);
}

TEST(Flags, WithATrueGuardTimeCannotPassAndNoProcessIsStuck) {
    const Explored bare(axis, {.ablations = {.cycle_always = true}});
    ASSERT_TRUE(bare.all.complete);
    for (const TaddState& state : bare.all.states) {
        EXPECT_FALSE(bare.time_can_pass(state));
        EXPECT_FALSE(bare.tadd.successors(state).empty()) << "UPPAAL would report a deadlock";
    }
    EXPECT_EQ(bare.count([&](const TaddState& state) { return bare.value(state, "H") > 0; }), 0U)
        << "the axis never moves";
}

TEST(Flags, WithThemTimePassesInSomeStateAfterEveryState) {
    const Explored cured(axis, {});
    for (TaddState state : cured.all.states) {
        for (int edges = 0; edges < 60 && !cured.time_can_pass(state); ++edges)
            state = cured.tadd.successors(state).front().next;
        ASSERT_TRUE(cured.time_can_pass(state));
    }
}

/// Returns the number of states in which step 0 is active, START is pressed, and no event wakes the controller: CEP13
/// section 6.3.
std::size_t sleeping(const Explored& loop) {
    return loop.count([&](const TaddState& state) {
        return loop.value(state, "X_0") == 1 && loop.value(state, "START") == 1 && loop.value(state, "EVOL_PL") == 0 &&
               loop.tadd.location(state, "PLC") == "W" && !loop.tadd.urgent_enabled(state);
    });
}

TEST(Stable, WithoutItTheTransientOfFigure27LeavesTheControllerAsleep) {
    EXPECT_GT(sleeping(Explored(axis, {.ablations = {.cycle_unless_stable = true}})), 0U);
    EXPECT_EQ(sleeping(Explored(axis, {})), 0U);
    EXPECT_EQ(sleeping(Explored(axis, {.mode = ExecutionMode::EveryCycle})), 0U) << "the mode is not the cause";
}

TEST(Samples, TheOvenDoorNeverForcesItsBoltAndReachesEveryStep) {
    for (const Grain grain : {Grain::Atomic, Grain::Phased}) {
        const Explored oven(read_sample("oven_door/oven_door.grafcet", {.grain = grain}).network);
        ASSERT_TRUE(oven.all.complete) << oven.all.states.size();
        EXPECT_FALSE(oven.all.out_of_range);
        for (const char* property : {"one_order", "no_forced_bolt", "warned"})
            EXPECT_TRUE(oven.holds(property)) << property;
        for (const char* step : {"X_0", "X_1", "X_2", "X_3", "X_4", "X_10", "X_40", "X_42", "X_20"})
            EXPECT_GT(oven.count([&](const TaddState& state) { return oven.value(state, step) == 1; }), 0U) << step;
    }
}

TEST(Samples, TheTestingStationKeepsItsCupUpWhileItMoves) {
    for (const Grain grain : {Grain::Atomic, Grain::Phased}) {
        const Explored station(read_sample("testing_station/testing_station.grafcet", {.grain = grain}).network);
        ASSERT_TRUE(station.all.complete) << station.all.states.size();
        EXPECT_FALSE(station.all.out_of_range);
        EXPECT_TRUE(station.holds("P15"));
        for (const char* step : {"0", "1", "2", "3", "4", "5", "6", "10", "11", "12", "20", "21", "22", "23"}) {
            const std::string variable = "X_" + std::string(step);
            EXPECT_GT(
                station.count([&](const TaddState& state) { return station.value(state, variable.c_str()) == 1; }), 0U)
                << step;
        }
        EXPECT_EQ(station.count([&](const TaddState& state) {
            return station.value(state, "H") == 4 && station.value(state, "H_IN") == 1;
        }),
                  0U);
    }
}

TEST(Samples, TheFaultyStationComposesToAWellFormedNetwork) {
    const LoopUnderTest faulty = read_sample("testing_station/faulty.grafcet");
    EXPECT_EQ(verify(faulty.network), std::vector<std::string>{});
    EXPECT_EQ(verify(expand(faulty.network)), std::vector<std::string>{});
}

TEST(Controllers, OutputReadByAnotherControllerSignalsItsChanges) {
    const LoopUnderTest pair = read_loop(R"(
        grafcet press {
            input START; output DONE;
            initial step 0; step 1 { DONE; }
            transition t0: 0 -> 1 when START;
            transition t1: 1 -> 0 when !START;
        }
        grafcet belt {
            input DONE; output RUN;
            initial step 0; step 1 { RUN; }
            transition t0: 0 -> 1 when DONE;
            transition t1: 1 -> 0 when !DONE;
        }
        closed_loop line {
            controller press;
            controller belt;
            environment Start = push_button(OUT = START, GAP = 1s);
            plant Motor = lamp(ON = RUN);
            property follows: always !press.X1 || START at stable;
            property runs: always RUN == belt.X1 at stable;
            property both: never belt.X1 && !press.X1 at stable;
        })");
    const Explored line(pair.network);
    ASSERT_TRUE(line.all.complete);
    for (const char* property : {"follows", "runs", "both"}) EXPECT_TRUE(line.holds(property)) << property;
    EXPECT_GT(line.count([&](const TaddState& state) { return line.value(state, "belt_X_1") == 1; }), 0U);
    EXPECT_EQ(line.network.controllers.size(), 2U);
}

}  // namespace
}  // namespace grafverif
