// SPDX-License-Identifier: MIT
// Tests macro-steps, enclosing steps and forcing orders.
#include <gtest/gtest.h>

#include "support/play.hpp"

namespace grafverif {
namespace {

constexpr const char* macro =
    "input a, b, c; initial step 1; macro step M expands E; step 3;"
    "transition t1: 1 -> M when a; transition t2: M -> 3 when b; transition t3: 3 -> 1 when c;"
    "expansion E { entry step 10; step 11; exit step 12;"
    "transition e1: 10 -> 11 when b; transition e2: 11 -> 12 when c; }";

TEST(MacroSteps, AreEnteredAtTheirEntryAndLeftFromTheirExit) {
    Play chart = play(macro);
    run(chart);
    run(chart, "a");
    EXPECT_EQ(situation(chart), "M 10");
    run(chart, "b");  // t2 needs the exit step
    EXPECT_EQ(situation(chart), "M 11");
    run(chart, "c");
    EXPECT_EQ(situation(chart), "M 12");
    run(chart, "b");
    EXPECT_EQ(situation(chart), "3");
}

TEST(MacroSteps, StayActiveWhileTheirExpansionIs) {
    Play chart = play(
        "input a; internal N: int 0..9 = 0; initial step 1; macro step M expands E { N := N + 1 on activation; }"
        "transition t1: 1 -> 1, M when rise(a); transition t2: M -> when true;"
        "expansion E { entry step 10; step 11; exit step 12;"
        "transition e1: 10 -> 11 when fall(a); transition e2: 11 -> 12 when rise(a); }");
    run(chart);
    run(chart, "a");
    run(chart);
    EXPECT_EQ(situation(chart), "1 M 11");
    run(chart, "a");  // steps 10 and 12 are entered together; then step 12 is left, and step 10 keeps M active
    EXPECT_EQ(situation(chart), "1 M 10");
    EXPECT_EQ(value(chart, "N"), 1);
}

TEST(MacroSteps, HaveTheirOwnExpansionEachAlsoNested) {
    Play chart = play(
        "input a, b; initial macro step M1 expands E1; step 9; transition t1: M1 -> 9 when b;"
        "expansion E1 { entry macro step M2 expands E2; exit macro step M3 expands E3;"
        "transition e1: M2 -> M3 when a; }"
        "expansion E2 { entry step 20; exit step 21; transition e2: 20 -> 21 when true; }"
        "expansion E3 { entry step 30; exit step 31; transition e3: 30 -> 31 when true; }");
    EXPECT_EQ(situation(chart), "M1 M2 20");
    run(chart);
    EXPECT_EQ(situation(chart), "M1 M2 21");
    run(chart, "a");
    EXPECT_EQ(situation(chart), "M1 M3 31");
    run(chart, "b");
    EXPECT_EQ(situation(chart), "9");
}

constexpr const char* enclosure =
    "input a, b, c; internal N: int 0..9 = 0; initial step 1; enclosing step 6 encloses G;"
    "transition t1: 1 -> 6 when a; transition t2: 6 -> 1 when b;"
    "partial G { initial step 20; linked step 21 { N := N + 1 on activation; } step 22 { N := 9 on activation; }"
    "transition g1: 21 -> 22 when b; transition g2: 21 -> 20 when c; transition g3: -> 21 when c; }";

TEST(EnclosingSteps, ActivateTheirLinksAndNotTheInitialSteps) {
    Play chart = play(enclosure);
    // Initial step 20 is not active at power-on, because its enclosing step 6 is inactive.
    EXPECT_EQ(situation(chart), "1");
    run(chart);
    run(chart, "a");
    EXPECT_EQ(situation(chart), "6 21");
    EXPECT_EQ(value(chart, "N"), 1);
}

TEST(EnclosingSteps, DeactivateAllEnclosedStepsRegardlessOfTransitionsThere) {
    Play chart = play(enclosure);
    run(chart);
    run(chart, "a");
    const Cycle left = run(chart, "b");
    EXPECT_EQ(fired(chart, left), "t2 g1; ; ");
    EXPECT_EQ(situation(chart), "1");
    EXPECT_EQ(value(chart, "N"), 1);  // step 22 was not activated
}

TEST(EnclosingSteps, EnableTheSourceTransitionsOfTheirChartsOnlyWhileActive) {
    Play chart = play(enclosure);
    run(chart);
    EXPECT_TRUE(run(chart, "c").endless.empty());
    EXPECT_EQ(situation(chart), "1");
}

TEST(EnclosingSteps, Nest) {
    Play chart = play(
        "input a, b; initial step 1; enclosing step 2 encloses G; transition t1: 1 -> 2 when a;"
        "transition t2: 2 -> 1 when b;"
        "partial G { linked enclosing step 3 encloses H; } partial H { linked step 4; }");
    run(chart);
    run(chart, "a");
    EXPECT_EQ(situation(chart), "2 3 4");
    run(chart, "b");
    EXPECT_EQ(situation(chart), "1");
}

/// Returns the active steps of a chart in which the forcing order `order`, on its partial chart G, has become active.
std::string forced_to(const std::string& order, std::string* afterwards = nullptr) {
    Play chart = play("input a, b; initial step 1; step 2 { force G := {" + order +
                      "}; }"
                      "transition t1: 1 -> 2 when rise(a); transition t2: 2 -> 1 when fall(a);"
                      "partial G { initial step 20; step 21; step 22;"
                      "transition g1: 20 -> 21 when rise(b); transition g2: 21 -> 22 when rise(b); }");
    run(chart);
    run(chart, "b");
    run(chart);
    run(chart, "a");
    const std::string reached = situation(chart);
    run(chart, "a b");  // the forcing order keeps the situation
    EXPECT_EQ(situation(chart), reached);
    run(chart, "b");
    if (afterwards != nullptr) *afterwards = situation(chart);
    return reached;
}

TEST(ForcingOrders, OfAllFourFormsForceAndHold) {
    std::string afterwards;
    EXPECT_EQ(forced_to(""), "2");
    EXPECT_EQ(forced_to("INIT"), "2 20");
    EXPECT_EQ(forced_to("22, 20"), "2 20 22");
    EXPECT_EQ(forced_to("*", &afterwards), "2 21");
    EXPECT_EQ(afterwards, "1 21");  // the rise of b during the order has no effect afterwards
}

TEST(ForcingOrders, ForceInTheEvolutionThatActivatesTheirStep) {
    Play chart = play(
        "input a; internal N: int 0..9 = 0; initial step 1; step 2 { force G := {20}; }"
        "transition t1: 1 -> 2 when a;"
        "partial G { initial step 20; step 21 { N := 1 on activation; } transition g1: 20 -> 21 when a; }");
    run(chart);
    EXPECT_EQ(fired(chart, run(chart, "a")), "t1 g1; ; ");
    EXPECT_EQ(situation(chart), "2 20");
    EXPECT_EQ(value(chart, "N"), 0);
}

TEST(ForcingOrders, GoDownSeveralLevelsAtOnce) {
    Play chart = play(
        "input a; initial step 1; step 2 { force G := {21}; } transition t1: 1 -> 2 when a;"
        "partial G { initial step 20; step 21 { force H := {}; } transition g1: 21 -> 20 when a; }"
        "partial H { initial step 30; }");
    run(chart);
    EXPECT_EQ(situation(chart), "1 20 30");
    EXPECT_EQ(fired(chart, run(chart, "a")), "t1; ; ");
    EXPECT_EQ(situation(chart), "2 21");
}

TEST(ForcingOrders, AreObeyedAtPowerOn) {
    EXPECT_EQ(situation(play("initial step 1 { force G := {21}; }"
                             "partial G { initial step 20; step 21; transition g1: 21 -> 20 when true; }")),
              "1 21");
}

TEST(ForcingOrders, ThatCannotBeObeyedTogetherAreAFaultOfTheChart) {
    Play chart = play(
        "input a; initial step 1; step 2 { force G := {}; } initial step 3; step 4 { force G := {20}; }"
        "transition t1: 1 -> 2 when a; transition t2: 3 -> 4 when a; partial G { initial step 20; }");
    run(chart);
    const Cycle apart = run(chart, "a");
    ASSERT_TRUE(apart.fault.has_value());
    EXPECT_EQ(apart.fault->kind, RunFault::Kind::ForcedApart);
}

}  // namespace
}  // namespace grafverif
