// SPDX-License-Identifier: MIT
// Tests the components barrier, lift_car, burner, fan and delayed_signal.
#include <gtest/gtest.h>

#include "library.hpp"

namespace grafverif {
namespace {

using Values = std::set<std::int64_t>;
using Places = std::set<std::string>;

TEST(Barrier, StopsBetweenItsEndsWhenTheOrderFalls) {
    Bench boom = bench("barrier", {{"RISING", 3000}, {"SINKING", 2000}});
    EXPECT_EQ(only(boom, "DOWN"), 1);
    boom.set("RAISE", 1);
    EXPECT_EQ(only(boom, "DOWN"), 0);
    boom.wait(2);
    boom.set("RAISE", 0);
    EXPECT_EQ(place_of(boom), "between");
    boom.wait(9);
    EXPECT_EQ(only(boom, "UP"), 0);
    boom.set("LOWER", 1);
    boom.wait(1);
    EXPECT_EQ(only(boom, "DOWN"), 0);
    boom.wait(1);
    EXPECT_EQ(only(boom, "DOWN"), 1);
}

TEST(Barrier, DoesNotMoveUnderBothOrders) {
    Bench boom = bench("barrier");
    boom.set("RAISE", 1);
    boom.wait(3);
    EXPECT_EQ(only(boom, "UP"), 1);
    boom.set("LOWER", 1);
    boom.wait(9);
    EXPECT_EQ(place_of(boom), "up");
    boom.set("RAISE", 0);
    EXPECT_EQ(place_of(boom), "sinking");
    boom.set("RAISE", 1);
    EXPECT_EQ(place_of(boom), "between");
}

TEST(LiftCar, PassesItsFloorsAndStopsAtTheHighest) {
    Bench car = bench("lift_car", {{"TOP", 2}});
    car.set("UP", 1);
    const std::vector<std::pair<std::int64_t, std::int64_t>> floors_and_levels{{0, 0}, {1, 1}, {1, 0}, {2, 1}, {2, 1}};
    for (const auto& [floor, level] : floors_and_levels) {
        car.wait(1);
        EXPECT_EQ(only(car, "FLOOR"), floor);
        EXPECT_EQ(only(car, "LEVEL"), level);
    }
    EXPECT_EQ(place_of(car), "standing");
}

TEST(LiftCar, KeepsItsFloorHalfWayAndComesBack) {
    Bench car = bench("lift_car", {{"TOP", 2}, {"START", 1}});
    EXPECT_EQ(only(car, "FLOOR"), 1);
    car.set("DOWN", 1);
    car.wait(1);
    car.set("DOWN", 0);
    car.wait(5);
    EXPECT_EQ(only(car, "FLOOR"), 1);
    EXPECT_EQ(only(car, "LEVEL"), 0);
    car.set("UP", 1);
    car.wait(1);
    car.set("DOWN", 1);  // the orders UP and DOWN are both true
    car.wait(5);
    EXPECT_EQ(only(car, "FLOOR"), 1);
    EXPECT_EQ(only(car, "LEVEL"), 1);
    car.set("UP", 0);
    car.wait(2);
    EXPECT_EQ(only(car, "FLOOR"), 0);
    car.wait(5);
    EXPECT_EQ(only(car, "LEVEL"), 1);
}

TEST(Burner, NeedsSparkAndGasForItsFlame) {
    Bench burner = bench("burner", {{"LIGHT", 2000}, {"RELIABLE", 1}});
    burner.set("SPARK", 1);
    EXPECT_EQ(place_of(burner), "out");
    burner.set("SPARK", 0);
    burner.set("GAS", 1);
    burner.wait(5);
    EXPECT_EQ(place_of(burner), "unburnt");
    burner.set("SPARK", 1);
    EXPECT_EQ(only(burner, "FLAME"), 0);
    burner.wait(1);  // LIGHT is the only duration, so that it is one unit
    EXPECT_EQ(only(burner, "FLAME"), 1);
    burner.set("SPARK", 0);
    burner.wait(9);
    EXPECT_EQ(only(burner, "FLAME"), 1);
    burner.set("GAS", 0);
    EXPECT_EQ(place_of(burner), "out");
    EXPECT_EQ(only(burner, "FLAME"), 0);
}

TEST(Burner, MayFailToLightAndGoOutUnlessReliable) {
    Bench burner = bench("burner");
    burner.set("GAS", 1);
    burner.set("SPARK", 1);
    burner.wait(9);
    EXPECT_EQ(burner.locations("it"), (Places{"burning", "lighting"}));
    burner.set("SPARK", 0);
    EXPECT_EQ(burner.locations("it"), (Places{"burning", "unburnt"}));
}

TEST(Fan, RunsUpAndFailsUnlessReliable) {
    Bench fan = bench("fan", {{"RUN_UP", 2000}, {"RUN_DOWN", 3000}});
    fan.set("ON", 1);
    fan.wait(1);
    EXPECT_EQ(fan.values("FLOW"), (Values{0}));
    fan.wait(1);
    EXPECT_EQ(fan.locations("it"), (Places{"running", "failed"}));
    fan.set("ON", 0);
    EXPECT_EQ(only(fan, "FLOW"), 0);
    fan.wait(3);
    EXPECT_EQ(place_of(fan), "stopped");
    Bench sound = bench("fan", {{"RUN_UP", 2000}, {"RELIABLE", 1}});
    sound.set("ON", 1);
    sound.wait(9);
    EXPECT_EQ(only(sound, "FLOW"), 1);
}

TEST(DelayedSignal, IgnoresPulsesShorterThanItsDelay) {
    Bench monitor = bench("delayed_signal", {{"ON_DELAY", 2000}, {"OFF_DELAY", 3000}});
    monitor.set("REAL", 1);
    monitor.wait(1);
    monitor.set("REAL", 0);
    monitor.set("REAL", 1);
    monitor.wait(1);
    EXPECT_EQ(only(monitor, "READ"), 0);
    monitor.wait(1);
    EXPECT_EQ(only(monitor, "READ"), 1);
    monitor.set("REAL", 0);
    monitor.wait(2);
    EXPECT_EQ(only(monitor, "READ"), 1);
    monitor.wait(1);
    EXPECT_EQ(only(monitor, "READ"), 0);
}

}  // namespace
}  // namespace grafverif
