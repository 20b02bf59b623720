// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "library.hpp"

namespace grafverif {
namespace {

/// Returns a bench with the component `name` alone. The inputs in `orders` are true initially, so they become true
/// simultaneously.
Bench bench_ordered(const std::string& name, const std::map<std::string, std::int64_t>& constants,
                    const std::vector<std::string>& orders) {
    Network network = lone_component(library_component(name), constants);
    for (Network::Variable& variable : network.variables)
        if (std::ranges::find(orders, variable.name) != orders.end()) variable.initial = 1;
    return Bench(network);
}

TEST(Cylinder53, MovesByItsStepEachSecondWhileOrdered) {
    Bench cylinder = bench("cylinder_5_3", {{"X_max", 20}, {"D_X", 2}});
    cylinder.set("G_OUT", 1);
    EXPECT_EQ(only(cylinder, "X"), 0);
    for (std::int64_t x = 2; x <= 20; x += 2) {
        cylinder.wait(1);
        EXPECT_EQ(only(cylinder, "X"), x);
    }
    EXPECT_EQ(place_of(cylinder), "still");
    cylinder.wait(3);
    EXPECT_EQ(only(cylinder, "X"), 20);
}

TEST(Cylinder53, NeedsItsDurationPerStep) {
    Bench cylinder = bench("cylinder_5_3", {{"X_max", 2}, {"STEP", 3000}, {"X_min", 0}});
    cylinder.set("G_OUT", 1);
    cylinder.wait(1);  // STEP is the only duration, so that one unit is 3 s
    EXPECT_EQ(only(cylinder, "X"), 1);
}

TEST(Cylinder53, ClampsTheLastMovementAtBothEnds) {
    Bench cylinder = bench("cylinder_5_3", {{"X_min", 1}, {"X_max", 6}, {"D_X", 3}});
    cylinder.set("G_OUT", 1);
    cylinder.wait(1);
    EXPECT_EQ(only(cylinder, "X"), 4);
    cylinder.wait(1);
    EXPECT_EQ(only(cylinder, "X"), 6);
    EXPECT_EQ(place_of(cylinder), "still");
    cylinder.set("G_OUT", 0);
    cylinder.set("G_IN", 1);
    cylinder.wait(1);
    EXPECT_EQ(only(cylinder, "X"), 3);
    cylinder.wait(1);
    EXPECT_EQ(only(cylinder, "X"), 1);
    EXPECT_EQ(place_of(cylinder), "still");
}

TEST(Cylinder53, StopsAtOnceWhenTheOrderFalls) {
    Bench cylinder = bench("cylinder_5_3", {{"X_max", 10}});
    cylinder.set("G_OUT", 1);
    cylinder.wait(4);
    cylinder.set("G_OUT", 0);
    EXPECT_EQ(place_of(cylinder), "still");
    cylinder.wait(5);
    EXPECT_EQ(only(cylinder, "X"), 4);
}

TEST(Cylinder53, ReversesWhenTheOrdersAreExchanged) {
    Bench cylinder = bench("cylinder_5_3", {{"X_max", 10}});
    cylinder.set("G_OUT", 1);
    cylinder.wait(4);
    cylinder.set("G_OUT", 0);
    cylinder.set("G_IN", 1);
    EXPECT_EQ(place_of(cylinder), "going_in");
    cylinder.wait(3);
    EXPECT_EQ(only(cylinder, "X"), 1);
}

TEST(Cylinder53, ObeysTheFirstOfTwoOrders) {
    Bench cylinder = bench("cylinder_5_3", {{"X_max", 10}});
    cylinder.set("G_OUT", 1);
    cylinder.wait(2);
    cylinder.set("G_IN", 1);
    EXPECT_EQ(place_of(cylinder), "going_out");
    cylinder.wait(8);
    EXPECT_EQ(only(cylinder, "X"), 10);
    cylinder.wait(2);
    EXPECT_EQ(only(cylinder, "X"), 10);
    cylinder.set("G_OUT", 0);
    EXPECT_EQ(place_of(cylinder), "going_in");
}

TEST(Cylinder53, DoesNotMoveOnTwoOrdersOfTheSameInstant) {
    Bench cylinder = bench_ordered("cylinder_5_3", {{"X_max", 10}}, {"G_IN", "G_OUT"});
    cylinder.wait(3);
    EXPECT_EQ(place_of(cylinder), "still");
    EXPECT_EQ(only(cylinder, "X"), 0);
    cylinder.set("G_IN", 0);
    EXPECT_EQ(place_of(cylinder), "going_out");
}

TEST(Cylinder53, LandsOnItsEndsExactly) {
    Bench cylinder = bench("cylinder_5_3", {{"X_max", 6}, {"D_X", 2}});
    cylinder.set("G_OUT", 1);
    cylinder.wait(3);
    EXPECT_EQ(place_of(cylinder), "still");
    cylinder.set("G_OUT", 0);
    cylinder.set("G_IN", 1);
    cylinder.wait(3);
    EXPECT_EQ(only(cylinder, "X"), 0);
    EXPECT_EQ(place_of(cylinder), "still");
}

TEST(Cylinder53, CanStartAnywhere) {
    EXPECT_EQ(only(bench("cylinder_5_3", {{"X_min", 2}, {"X_max", 10}}), "X"), 2);
    EXPECT_EQ(only(bench("cylinder_5_3", {{"X_max", 10}, {"X_start", 7}}), "X"), 7);
    EXPECT_EQ(only(bench("cylinder_5_3_stuck", {{"X_max", 10}, {"X_start", 7}}), "X"), 7);
    EXPECT_EQ(place_of(bench("cylinder_monostable", {{"X_max", 10}, {"X_start", 7}})), "going_in");
}

TEST(Cylinder53Stuck, IsACylinderLikeAnyOtherWhileItIsNotStuck) {
    for (const std::int64_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
        SCOPED_TRACE(seed);
        std::mt19937_64 random(static_cast<std::uint64_t>(seed));
        const std::map<std::string, std::int64_t> constants{{"X_max", 3 + seed % 4}, {"D_X", 1 + seed % 3}};
        Bench sound = bench("cylinder_5_3", constants), other = bench("cylinder_5_3_stuck", constants);
        for (int i = 0; i < 300; ++i) {
            const std::string order = random() % 2 == 0 ? "G_IN" : "G_OUT";
            const auto value = static_cast<std::int64_t>(random() % 2);
            const auto pause = static_cast<std::int64_t>(random() % 4);
            for (Bench* cylinder : {&sound, &other}) {
                cylinder->set(order, value);
                cylinder->wait(pause);
            }
            ASSERT_EQ(only(sound, "X"), only(other, "X"));
            ASSERT_EQ(place_of(sound), place_of(other));
        }
    }
}

TEST(Cylinder53Stuck, DoesNotMoveOnTwoOrdersOfTheSameInstant) {
    const Bench cylinder = bench_ordered("cylinder_5_3_stuck", {{"X_max", 10}, {"X_start", 5}}, {"G_IN", "G_OUT"});
    EXPECT_EQ(place_of(cylinder), "still");
}

TEST(Cylinder53Stuck, StopsAtOnceAndStaysWhileStuck) {
    Bench cylinder = bench("cylinder_5_3_stuck", {{"X_max", 10}});
    cylinder.set("G_OUT", 1);
    cylinder.wait(3);
    cylinder.set("STUCK", 1);
    EXPECT_EQ(place_of(cylinder), "still");
    cylinder.wait(5);
    EXPECT_EQ(only(cylinder, "X"), 3);
    cylinder.set("G_OUT", 0);
    cylinder.set("G_IN", 1);
    cylinder.wait(5);
    EXPECT_EQ(only(cylinder, "X"), 3);
    cylinder.set("STUCK", 0);
    cylinder.wait(3);
    EXPECT_EQ(only(cylinder, "X"), 0);
}

TEST(Cylinder52, CompletesItsStrokeAfterAShortOrder) {
    Bench cylinder = bench("cylinder_5_2", {{"STROKE_OUT", 3000}, {"STROKE_IN", 2000}});
    EXPECT_EQ(only(cylinder, "IN"), 1);
    cylinder.set("G_OUT", 1);
    EXPECT_EQ(only(cylinder, "IN"), 0);
    cylinder.set("G_OUT", 0);
    cylinder.wait(2);
    EXPECT_EQ(only(cylinder, "OUT"), 0);
    cylinder.wait(1);
    EXPECT_EQ(only(cylinder, "OUT"), 1);
    cylinder.set("G_IN", 1);
    EXPECT_EQ(only(cylinder, "OUT"), 0);
    cylinder.wait(1);
    EXPECT_EQ(only(cylinder, "IN"), 0);
    cylinder.wait(1);
    EXPECT_EQ(only(cylinder, "IN"), 1);
}

TEST(Cylinder52, ReversesOnTheOppositeOrderAndNeedsACompleteStrokeBack) {
    Bench cylinder = bench("cylinder_5_2", {{"STROKE_OUT", 3000}, {"STROKE_IN", 2000}});
    cylinder.set("G_OUT", 1);
    cylinder.wait(1);
    cylinder.set("G_OUT", 0);
    cylinder.set("G_IN", 1);
    EXPECT_EQ(place_of(cylinder), "moving_in");
    cylinder.wait(1);
    EXPECT_EQ(only(cylinder, "IN"), 0);
    cylinder.wait(1);
    EXPECT_EQ(only(cylinder, "IN"), 1);
}

TEST(Cylinder52, KeepsMovingWithBothOrders) {
    Bench cylinder = bench("cylinder_5_2", {{"STROKE_OUT", 3000}, {"STROKE_IN", 2000}});
    cylinder.set("G_OUT", 1);
    cylinder.set("G_IN", 1);
    cylinder.wait(3);
    EXPECT_EQ(only(cylinder, "OUT"), 1);
    cylinder.wait(3);
    EXPECT_EQ(only(cylinder, "OUT"), 1);
}

TEST(Cylinder52, DoesNotMoveOnTwoOrdersOfTheSameInstant) {
    EXPECT_EQ(place_of(bench_ordered("cylinder_5_2", {}, {"G_IN", "G_OUT"})), "in");
}

TEST(Cylinder52, ReversesWhileRetracting) {
    Bench cylinder = bench("cylinder_5_2", {{"STROKE_OUT", 3000}, {"STROKE_IN", 2000}}, "out");
    cylinder.set("G_IN", 1);
    cylinder.wait(1);
    cylinder.set("G_OUT", 1);
    EXPECT_EQ(place_of(cylinder), "moving_in");
    cylinder.set("G_IN", 0);
    EXPECT_EQ(place_of(cylinder), "moving_out");
    cylinder.wait(2);
    EXPECT_EQ(only(cylinder, "OUT"), 0);
    cylinder.wait(1);
    EXPECT_EQ(only(cylinder, "OUT"), 1);
}

TEST(Cylinder52, CanStartOut) {
    const Bench cylinder = bench("cylinder_5_2", {}, "out");
    EXPECT_EQ(only(cylinder, "OUT"), 1);
    EXPECT_EQ(only(cylinder, "IN"), 0);
}

TEST(CylinderMonostable, SpringsBackWithoutOrder) {
    Bench cylinder = bench("cylinder_monostable", {{"X_max", 5}, {"D_X", 2}});
    cylinder.set("G_OUT", 1);
    cylinder.wait(2);
    EXPECT_EQ(only(cylinder, "X"), 4);
    cylinder.set("G_OUT", 0);
    EXPECT_EQ(place_of(cylinder), "going_in");
    cylinder.wait(1);
    EXPECT_EQ(only(cylinder, "X"), 2);
    cylinder.wait(1);
    EXPECT_EQ(only(cylinder, "X"), 0);
    EXPECT_EQ(place_of(cylinder), "still");
}

TEST(CylinderMonostable, StaysOutWhileOrdered) {
    Bench cylinder = bench("cylinder_monostable", {{"X_max", 3}});
    cylinder.set("G_OUT", 1);
    cylinder.wait(3);
    EXPECT_EQ(only(cylinder, "X"), 3);
    EXPECT_EQ(place_of(cylinder), "still");
    cylinder.wait(9);
    EXPECT_EQ(only(cylinder, "X"), 3);
}

}  // namespace
}  // namespace grafverif
