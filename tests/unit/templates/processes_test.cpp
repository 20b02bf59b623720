// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "library.hpp"

namespace grafverif {
namespace {

using Values = std::set<std::int64_t>;

TEST(TestingDevice, RespondsFourSecondsAfterItsOrderWithEitherResult) {
    const Network network = component_in_seconds("testing_device");
    const NaiveTadd tadd(network);
    Bench device(network);
    device.set("TEST", 1);
    device.wait(3);
    EXPECT_EQ(place_of(device), "testing");
    device.wait(1);
    EXPECT_EQ(device.locations("it"), (std::set<std::string>{"passed", "failed"}));
    for (const TaddState& state : device.states())
        EXPECT_EQ(tadd.variable(state, tadd.location(state, "it") == "passed" ? "OK" : "KO"), 1);
    for (const TaddState& state : device.states())
        EXPECT_EQ(tadd.variable(state, "OK") + tadd.variable(state, "KO"), 1);
    device.set("TEST", 0);
    EXPECT_EQ(only(device, "OK"), 0);
    EXPECT_EQ(only(device, "KO"), 0);
    EXPECT_EQ(place_of(device), "idle");
}

TEST(TestingDevice, AbandonsATestWhenItsOrderFalls) {
    Bench device = bench("testing_device");
    device.set("TEST", 1);
    device.set("TEST", 0);
    EXPECT_EQ(place_of(device), "idle");
    device.wait(9);
    EXPECT_EQ(only(device, "OK"), 0);
    EXPECT_EQ(only(device, "KO"), 0);
}

TEST(TankLevel, RisesAndFallsByItsPortionAndClamps) {
    Bench tank = bench("tank_level", {{"LEVEL_max", 5}, {"D_LEVEL", 2}});
    tank.set("FILL", 1);
    tank.wait(1);
    EXPECT_EQ(only(tank, "LEVEL"), 2);
    tank.wait(9);
    EXPECT_EQ(only(tank, "LEVEL"), 5);
    tank.set("FILL", 0);
    tank.wait(9);
    EXPECT_EQ(only(tank, "LEVEL"), 5);
    tank.set("DRAIN", 1);
    tank.wait(2);
    EXPECT_EQ(only(tank, "LEVEL"), 1);
    tank.wait(9);
    EXPECT_EQ(only(tank, "LEVEL"), 0);
}

TEST(TankLevel, LandsOnItsEndsExactly) {
    Bench tank = bench("tank_level", {{"LEVEL_max", 4}, {"D_LEVEL", 2}});
    tank.set("FILL", 1);
    tank.wait(2);
    EXPECT_EQ(only(tank, "LEVEL"), 4);
    EXPECT_EQ(place_of(tank), "steady");
    tank.set("FILL", 0);
    tank.set("DRAIN", 1);
    tank.wait(2);
    EXPECT_EQ(only(tank, "LEVEL"), 0);
    EXPECT_EQ(place_of(tank), "steady");
    EXPECT_EQ(only(bench("tank_level", {{"LEVEL_max", 4}, {"LEVEL_start", 3}}), "LEVEL"), 3);
}

TEST(TankLevel, StaysWhileAsMuchFlowsOutAsIn) {
    Bench tank = bench("tank_level", {{"LEVEL_max", 5}});
    tank.set("FILL", 1);
    tank.wait(3);
    tank.set("DRAIN", 1);
    EXPECT_EQ(place_of(tank), "steady");
    tank.wait(9);
    EXPECT_EQ(only(tank, "LEVEL"), 3);
    tank.set("FILL", 0);
    tank.wait(1);
    EXPECT_EQ(only(tank, "LEVEL"), 2);
}

TEST(PartFeeder, AnEndlessOneRefillsInItsTime) {
    Bench feeder = bench("part_feeder", {{"ENDLESS", 1}});
    EXPECT_EQ(only(feeder, "PRESENT"), 1);
    feeder.set("TAKE", 1);
    EXPECT_EQ(only(feeder, "PRESENT"), 0);
    feeder.wait(5);
    EXPECT_EQ(only(feeder, "PRESENT"), 0);
    feeder.set("TAKE", 0);
    EXPECT_EQ(only(feeder, "PRESENT"), 0);
    feeder.wait(1);
    EXPECT_EQ(only(feeder, "PRESENT"), 1);
}

TEST(PartFeeder, AnyOtherMayRunDry) {
    Bench feeder = bench("part_feeder");
    feeder.wait(5);
    feeder.set("TAKE", 1);
    feeder.set("TAKE", 0);
    EXPECT_EQ(place_of(feeder), "waiting");
    EXPECT_EQ(only(feeder, "PRESENT"), 0);
    feeder.wait(1);
    EXPECT_EQ(feeder.values("PRESENT"), (Values{0, 1}));
    feeder.wait(50);
    EXPECT_EQ(feeder.values("PRESENT"), (Values{0, 1}));
}

TEST(StuckFault, OccursAtAnyTimeAndStays) {
    const Network network = lone_component(library_component("stuck_fault"));
    const NaiveTadd tadd(network);
    EXPECT_EQ(tadd.variable(tadd.initial(), "FAULT"), 0);
    EXPECT_EQ(bench("stuck_fault").values("FAULT"), (Values{0, 1}));
    for (const TaddState& state : reachable(network, 100).states)
        for (const TaddMove& move : tadd.successors(state))
            EXPECT_GE(tadd.variable(move.next, "FAULT"), tadd.variable(state, "FAULT"));
}

TEST(StuckSensors, FollowTheirReadingUntilTheyStickForever) {
    struct Case {
        std::string name;
        std::int64_t stuck;
    };
    for (const auto& [name, stuck] : {Case{"sensor_stuck_at_0", 0}, {"sensor_stuck_at_1", 1}}) {
        SCOPED_TRACE(name);
        const Network network = lone_component(library_component(name));
        const NaiveTadd tadd(network);
        Bench sensor(network);
        for (const std::int64_t real : {0, 1, 0, 1}) {
            sensor.set("REAL", real);
            bool sound = false, broken = false;
            for (const TaddState& state : sensor.states()) {
                const auto sticks = [&](const TaddMove& move) { return tadd.location(move.next, "it") == "stuck"; };
                EXPECT_TRUE(std::ranges::any_of(tadd.successors(state), sticks));
                const bool is_stuck = tadd.location(state, "it") == "stuck";
                EXPECT_EQ(tadd.variable(state, "READ"), is_stuck ? stuck : real);
                (is_stuck ? broken : sound) = true;
            }
            EXPECT_TRUE(sound && broken);
        }
    }
}

}  // namespace
}  // namespace grafverif
