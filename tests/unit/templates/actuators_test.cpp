// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "library.hpp"

namespace grafverif {
namespace {

TEST(PassiveActuators, FollowTheirOrderAtOnce) {
    struct Case {
        std::string name, order, off, on;
    };
    for (const auto& [name, order, off, on] : {Case{"lamp", "ON", "dark", "lit"},
                                               {"buzzer", "ON", "silent", "sounding"},
                                               {"lock", "LOCK", "unlocked", "locked"},
                                               {"suction_pad", "P", "released", "sucking"}}) {
        SCOPED_TRACE(name);
        Bench actuator = bench(name);
        EXPECT_EQ(place_of(actuator), off);
        actuator.set(order, 1);
        EXPECT_EQ(place_of(actuator), on);
        actuator.set(order, 0);
        EXPECT_EQ(place_of(actuator), off);
    }
}

TEST(SuctionPadWithVacuumSensor, BuildsUpAndDecaysInItsTimes) {
    Bench pad = bench("suction_pad_with_vacuum_sensor", {{"BUILD", 2000}, {"DECAY", 3000}});
    pad.set("P", 1);
    pad.wait(1);
    EXPECT_EQ(only(pad, "VACUUM"), 0);
    pad.wait(1);
    EXPECT_EQ(only(pad, "VACUUM"), 1);
    pad.set("P", 0);
    pad.wait(2);
    EXPECT_EQ(only(pad, "VACUUM"), 1);
    pad.wait(1);
    EXPECT_EQ(only(pad, "VACUUM"), 0);
}

TEST(SuctionPadWithVacuumSensor, KeepsThePartWhenTheOrderComesBackInTime) {
    Bench pad = bench("suction_pad_with_vacuum_sensor", {{"BUILD", 2000}, {"DECAY", 3000}});
    pad.set("P", 1);
    pad.wait(2);
    pad.set("P", 0);
    pad.wait(2);
    pad.set("P", 1);
    EXPECT_EQ(place_of(pad), "holding");
    pad.wait(5);
    EXPECT_EQ(only(pad, "VACUUM"), 1);
}

TEST(Valve, DelaysItsOrderBothWays) {
    Bench valve = bench("valve", {{"TRAVEL", 2000}});
    valve.set("ORDER", 1);
    EXPECT_EQ(only(valve, "FLOW"), 0);
    valve.wait(1);  // TRAVEL is the only duration, so that it is one unit
    EXPECT_EQ(only(valve, "FLOW"), 1);
    valve.set("ORDER", 0);
    EXPECT_EQ(only(valve, "FLOW"), 1);
    valve.wait(1);
    EXPECT_EQ(only(valve, "FLOW"), 0);
}

TEST(Motor, RunsUpAndDown) {
    Bench motor = bench("motor", {{"RUN_UP", 2000}, {"RUN_DOWN", 3000}});
    motor.set("ON", 1);
    motor.wait(1);
    EXPECT_EQ(only(motor, "AT_SPEED"), 0);
    motor.wait(1);
    EXPECT_EQ(only(motor, "AT_SPEED"), 1);
    motor.set("ON", 0);
    EXPECT_EQ(only(motor, "AT_SPEED"), 0);
    motor.wait(2);
    EXPECT_EQ(place_of(motor), "stopping");
    motor.wait(1);
    EXPECT_EQ(place_of(motor), "stopped");
}

TEST(Motor, ChangeOfTheOrderRestartsTheOtherRamp) {
    Bench motor = bench("motor", {{"RUN_UP", 2000}, {"RUN_DOWN", 3000}});
    motor.set("ON", 1);
    motor.wait(1);
    motor.set("ON", 0);
    EXPECT_EQ(place_of(motor), "stopping");
    motor.set("ON", 1);
    motor.wait(1);
    EXPECT_EQ(only(motor, "AT_SPEED"), 0);
    motor.wait(1);
    EXPECT_EQ(only(motor, "AT_SPEED"), 1);
}

TEST(Conveyor, CarriesAPartFromEntryToExit) {
    Network network = lone_component(library_component("conveyor"), {{"LENGTH", 3}}, "resting");
    for (Network::Variable& variable : network.variables)
        if (variable.name == "AT_ENTRY") variable.initial = 1;
    Bench belt(network);
    belt.set("RUN", 1);
    EXPECT_EQ(only(belt, "AT_ENTRY"), 1);
    belt.wait(1);
    EXPECT_EQ(only(belt, "AT_ENTRY"), 0);
    belt.wait(1);
    belt.set("RUN", 0);
    belt.wait(7);
    EXPECT_EQ(only(belt, "AT_EXIT"), 0);
    belt.set("RUN", 1);
    belt.wait(1);
    EXPECT_EQ(only(belt, "AT_EXIT"), 1);
    belt.wait(1);
    EXPECT_EQ(only(belt, "AT_EXIT"), 0);
    EXPECT_EQ(place_of(belt), "empty");
}

TEST(Conveyor, PartsArriveAfterTheGapOrLaterOrNever) {
    Bench belt = bench("conveyor", {{"GAP", 2000}});
    belt.wait(1);
    EXPECT_EQ(only(belt, "AT_ENTRY"), 0);
    belt.wait(1);
    EXPECT_EQ(belt.values("AT_ENTRY"), (std::set<std::int64_t>{0, 1}));
    belt.wait(9);
    EXPECT_EQ(belt.values("AT_ENTRY"), (std::set<std::int64_t>{0, 1}));
}

}  // namespace
}  // namespace grafverif
