// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "library.hpp"

namespace grafverif {
namespace {

/// Returns the outputs `names` in order as digits: `100`.
std::string readings(const Bench& sensors, const std::vector<std::string>& names) {
    std::string digits;
    for (const std::string& name : names) digits += std::to_string(only(sensors, name));
    return digits;
}

TEST(PositionSensors2, SwitchExactlyAtTheirBoundsBothWays) {
    Bench sensors = bench("position_sensors_2", {{"X_IN_max", 1}, {"X_OUT_min", 9}}, "in");
    const auto expected = [](std::int64_t x) { return x < 1 ? "10" : x >= 9 ? "01" : "00"; };
    for (std::int64_t x = 0; x <= 10; ++x) {
        sensors.set("X", x);
        EXPECT_EQ(readings(sensors, {"IN", "OUT"}), expected(x)) << x;
    }
    for (std::int64_t x = 10; x >= 0; --x) {
        sensors.set("X", x);
        EXPECT_EQ(readings(sensors, {"IN", "OUT"}), expected(x)) << x;
    }
}

TEST(PositionSensors3, SwitchExactlyAtTheirBoundsBothWays) {
    Bench sensors =
        bench("position_sensors_3", {{"X_IN_max", 2}, {"X_MID_min", 9}, {"X_MID_max", 11}, {"X_OUT_min", 18}}, "in");
    const auto expected = [](std::int64_t x) {
        return x < 2 ? "100" : x >= 9 && x <= 11 ? "010" : x >= 18 ? "001" : "000";
    };
    for (std::int64_t x = 0; x <= 20; ++x) {
        sensors.set("X", x);
        EXPECT_EQ(readings(sensors, {"IN", "MID", "OUT"}), expected(x)) << x;
    }
    for (std::int64_t x = 20; x >= 0; --x) {
        sensors.set("X", x);
        EXPECT_EQ(readings(sensors, {"IN", "MID", "OUT"}), expected(x)) << x;
    }
}

TEST(PositionSensors3, FollowEveryJump) {
    const std::map<std::string, std::int64_t> bounds{
        {"X_IN_max", 2}, {"X_MID_min", 9}, {"X_MID_max", 11}, {"X_OUT_min", 18}};
    const auto expected = [](std::int64_t x) {
        return x < 2 ? "100" : x >= 9 && x <= 11 ? "010" : x >= 18 ? "001" : "000";
    };
    for (std::int64_t from = 0; from <= 20; ++from) {
        for (std::int64_t to = 0; to <= 20; ++to) {
            Bench sensors = bench("position_sensors_3", bounds, "in");
            sensors.set("X", from);
            sensors.set("X", to);
            EXPECT_EQ(readings(sensors, {"IN", "MID", "OUT"}), expected(to)) << from << " -> " << to;
        }
    }
}

TEST(PositionSensors3, AJumpOverTheMiddleGivesNoPulse) {
    Network network =
        lone_component(library_component("position_sensors_3"),
                       {{"X_IN_max", 2}, {"X_MID_min", 9}, {"X_MID_max", 11}, {"X_OUT_min", 18}}, "in_mid");
    for (const std::int64_t x : {5, 15}) {
        for (Network::Variable& variable : network.variables)
            if (variable.name == "X") variable.initial = x;
        const NaiveTadd tadd(network);
        for (const TaddState& state : reachable(network, 1000).states) EXPECT_EQ(tadd.variable(state, "MID"), 0) << x;
    }
}

TEST(PositionSensors, FindTheirPositionFromAnyStart) {
    const std::map<std::string, std::int64_t> bounds{
        {"X_IN_max", 2}, {"X_MID_min", 9}, {"X_MID_max", 11}, {"X_OUT_min", 18}};
    for (const std::string start : {"in", "in_mid", "mid", "mid_out", "out"}) {
        SCOPED_TRACE(start);
        Bench sensors = bench("position_sensors_3", bounds, start);
        sensors.set("X", 10);
        EXPECT_EQ(readings(sensors, {"IN", "MID", "OUT"}), "010");
    }
}

TEST(LevelSensors, AFullTankShowsBoth) {
    Bench sensors = bench("level_sensors", {{"LOW_min", 1}, {"HIGH_min", 4}}, "empty");
    const auto expected = [](std::int64_t level) { return level < 1 ? "00" : level < 4 ? "10" : "11"; };
    for (const std::int64_t level : {0, 1, 2, 3, 4, 5, 4, 3, 2, 1, 0, 5, 0}) {
        sensors.set("LEVEL", level);
        EXPECT_EQ(readings(sensors, {"LOW", "HIGH"}), expected(level)) << level;
    }
}

TEST(CombinationSensor, DetectsTheCombinationOfEitherPolarity) {
    for (const std::int64_t a_on : {0, 1}) {
        for (const std::int64_t b_on : {0, 1}) {
            Bench sensor = bench("combination_sensor", {{"A_ON", a_on}, {"B_ON", b_on}});
            for (const std::int64_t a : {0, 1, 0}) {
                for (const std::int64_t b : {0, 1, 0}) {
                    sensor.set("A", a);
                    sensor.set("B", b);
                    EXPECT_EQ(only(sensor, "OUT"), a == a_on && b == b_on);
                }
            }
        }
    }
}

TEST(CombinationSensor, CanStartOn) {
    EXPECT_EQ(place_of(bench("combination_sensor", {{"A_ON", 0}, {"B_ON", 0}}, "on")), "on");
}

TEST(OrSensor, DetectsEitherStateOfEitherPolarity) {
    for (const std::int64_t a_on : {0, 1})
        for (const std::int64_t b_on : {0, 1}) {
            Bench sensor = bench("or_sensor", {{"A_ON", a_on}, {"B_ON", b_on}});
            for (const std::int64_t a : {0, 1, 0})
                for (const std::int64_t b : {0, 1, 0}) {
                    sensor.set("A", a);
                    sensor.set("B", b);
                    EXPECT_EQ(only(sensor, "OUT"), a == a_on || b == b_on);
                }
        }
}

TEST(Junction, PassesOnPartsFromEitherSide) {
    Bench junction = bench("junction", {});
    for (const std::int64_t a : {0, 1, 0, 1})
        for (const std::int64_t b : {0, 1, 0}) {
            junction.set("A", a);
            junction.set("B", b);
            EXPECT_EQ(only(junction, "OUT"), a == 1 || b == 1);
        }
}

}  // namespace
}  // namespace grafverif
