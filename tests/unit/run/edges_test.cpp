// SPDX-License-Identifier: MIT
// Tests edges, and stored actions on events and on clearing.
#include <gtest/gtest.h>

#include "support/play.hpp"

namespace grafverif {
namespace {

TEST(Edges, TwoSuccessiveTransitionsOnOneEdgeNeedTwoPresses) {
    Play chart = play(
        "input a; initial step 1; step 2; step 3;"
        "transition t1: 1 -> 2 when rise(a); transition t2: 2 -> 3 when rise(a);");
    run(chart);
    run(chart, "a");
    EXPECT_EQ(situation(chart), "2");
    run(chart, "a");
    run(chart);
    EXPECT_EQ(situation(chart), "2");
    run(chart, "a");
    EXPECT_EQ(situation(chart), "3");
}

TEST(Edges, ThereIsNoneAtPowerOn) {
    Play chart = play(
        "input a; initial step 1; step 2;"
        "transition t1: 1 -> 2 when rise(a) || rise(X1) || fall(a);");
    run(chart, "a");
    EXPECT_EQ(situation(chart), "1");
    run(chart);
    EXPECT_EQ(situation(chart), "2");
}

TEST(Edges, OfAStepAreTrueInTheEvolutionAfterItsChange) {
    Play chart = play(
        "input a; initial step 1; step 2; initial step 8; step 9;"
        "transition t1: 1 -> 2 when a; transition t8: 8 -> 9 when rise(X2);");
    run(chart);
    EXPECT_EQ(fired(chart, run(chart, "a")), "t1; t8; ; ");
    EXPECT_EQ(situation(chart), "2 9");
}

TEST(Edges, DoNotMakeASituationUnstableIfTheyClearNoTransition) {
    Play chart =
        play("input a; initial step 1; step 2; transition t1: 1 -> 2 when fall(a); transition t2: 2 -> 1 when rise(a);",
             ExecutionMode::EveryCycle);
    run(chart);
    EXPECT_TRUE(run(chart, "a").stable);
    EXPECT_FALSE(run(chart).stable);
    EXPECT_EQ(situation(chart), "2");
    EXPECT_TRUE(run(chart).stable);
}

TEST(Edges, MakeASituationUnstableIfAConditionIsTrueAfterThem) {
    Play chart =
        play("input a; initial step 1; step 2; transition t1: 1 -> 2 when a && !rise(a);", ExecutionMode::EveryCycle);
    run(chart);
    EXPECT_TRUE(run(chart).stable);
    EXPECT_FALSE(run(chart, "a").stable);
    EXPECT_EQ(situation(chart), "1");
    EXPECT_FALSE(run(chart, "a").stable);
    EXPECT_EQ(situation(chart), "2");
    EXPECT_TRUE(run(chart, "a").stable);
}

TEST(Edges, AreOverBeforeADivisionByZero) {
    Play chart = play(
        "input a, b, c; internal N: int 0..3 = 0; initial step 1; step 2;"
        "transition t1: 1 -> 2 when (b || rise(a) || 2 / N == 1) && c;");
    EXPECT_FALSE(run(chart, "b").fault);
    EXPECT_FALSE(run(chart, "b").fault);
    EXPECT_TRUE(run(chart, "a").fault) << "in one more evolution, a has no edge";
}

TEST(Events, MakeASituationUnstableIfTheyExecuteAnAction) {
    Play chart = play(
        "input a; internal N: int 0..9 = 0; initial step 1 { N := 1 on event rise(a); } step 2;"
        "transition t1: 1 -> 2 when N == 1;");
    run(chart);
    EXPECT_EQ(fired(chart, run(chart, "a")), "; t1; ; ");
    EXPECT_EQ(situation(chart), "2");
}

TEST(Edges, OfATermCompareItsValueAsAWhole) {
    Play chart = play(
        "input a, b; initial step 1; internal N: int 0..9 = 0;"
        "transition t1: 1 -> 1 when rise(a || b) do N := N + 1;");
    run(chart);
    run(chart, "a");
    run(chart, "b");  // `a || b` remains true, so that there is no edge
    run(chart);
    run(chart, "a b");
    EXPECT_EQ(value(chart, "N"), 2);
}

TEST(Events, RunTheirActionOncePerEdgeWhileTheStepIsActive) {
    Play chart = play(
        "input a, b; internal N: int 0..9 = 0; initial step 1; step 2 { N := N + 1 on event rise(a); }"
        "transition t1: 1 -> 2 when rise(a); transition t2: 2 -> 1 when rise(b);");
    run(chart);
    run(chart, "a");  // the edge that activates the step occurs before the step is active
    EXPECT_EQ(value(chart, "N"), 0);
    run(chart);
    run(chart, "a");
    run(chart, "a");
    EXPECT_EQ(value(chart, "N"), 1);
    run(chart);
    run(chart, "a b");  // the step is active when the edge occurs, although the step is then left
    EXPECT_EQ(value(chart, "N"), 2);
    EXPECT_EQ(situation(chart), "1");
}

TEST(Clearing, RunsItsActionsEvenIfTheStepStaysActive) {
    Play chart = play(
        "input a; internal N: int 0..9 = 0; initial step 1 { N := 9 on activation; }"
        "transition t1: 1 -> 1 when rise(a) do N := N - 1;");
    run(chart);
    run(chart, "a");
    EXPECT_EQ(value(chart, "N"), 8);
}

TEST(Clearing, OfTwoTransitionsAtOnceCanRace) {
    Play chart = play(
        "input a; internal N: int 0..9 = 0; initial step 1; initial step 2;"
        "transition t1: 1 -> when a do N := 1; transition t2: 2 -> when a do N := 2;");
    run(chart);
    EXPECT_TRUE(run(chart, "a").race);
}

}  // namespace
}  // namespace grafverif
