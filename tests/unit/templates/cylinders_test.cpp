// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "library.hpp"

namespace grafverif {
namespace {

using Values = std::set<std::int64_t>;

/// A lone component with some inputs true from the start, all in the same instant.
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

TEST(Cylinder53, TakesItsDurationPerStep) {
    Bench cylinder = bench("cylinder_5_3", {{"X_max", 2}, {"STEP", 3000}, {"X_min", 0}});
    cylinder.set("G_OUT", 1);
    cylinder.wait(1);  // the only duration is STEP: one unit is 3 s
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

TEST(Cylinder53, TurnsRoundWhenTheOrdersChangePlaces) {
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

TEST(Cylinder52, TurnsRoundOnTheOppositeOrderAndTakesAWholeStrokeBack) {
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

TEST(Cylinder52, KeepsGoingOnTwoOrders) {
    Bench cylinder = bench("cylinder_5_2", {{"STROKE_OUT", 3000}, {"STROKE_IN", 2000}});
    cylinder.set("G_OUT", 1);
    cylinder.set("G_IN", 1);
    cylinder.wait(3);
    EXPECT_EQ(only(cylinder, "OUT"), 1);
    cylinder.wait(3);
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
    cylinder.wait(9);
    EXPECT_EQ(only(cylinder, "X"), 3);
}

}  // namespace
}  // namespace grafverif
