// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "support/play.hpp"

namespace grafverif {
namespace {

constexpr auto every_cycle = ExecutionMode::EveryCycle;

TEST(PowerOn, InitialStepsAreActiveAndOutputsAreOff) {
    const Play station = play("input a; output O; initial step 1 { O; } step 2; transition t1: 1 -> 2 when a;");
    EXPECT_EQ(situation(station), "1");
    EXPECT_EQ(outputs(station), "");
}

TEST(FirstEvolution, RunsTheActivationActionsOfInitialStepsAndClearsNothing) {
    Play chart = play(
        "output O; internal N: int 0..5 = 1; initial step 1 { O; N := N + 1 on activation; }"
        "step 2; transition t1: 1 -> 2 when true;",
        every_cycle);
    const Cycle first = run(chart);
    EXPECT_EQ(fired(chart, first), "; ");
    EXPECT_EQ(situation(chart), "1");
    EXPECT_EQ(value(chart, "N"), 2);
    EXPECT_EQ(outputs(chart), "O");
    EXPECT_FALSE(first.stable);
    EXPECT_EQ(fired(chart, run(chart)), "t1; ");
    EXPECT_EQ(value(chart, "N"), 2);
}

TEST(FirstEvolution, ReadsTheCurrentInputs) {
    Play chart = play(
        "input a; internal M = false; initial step 1 { M := a on activation; }"
        "step 2; transition t1: 1 -> 2 when false;");
    run(chart, "a");
    EXPECT_EQ(value(chart, "M"), 1);
    run(chart);
    EXPECT_EQ(value(chart, "M"), 1);
}

TEST(FirstEvolution, ReactivatedInitialStepRunsItsActionAgain) {
    Play chart = play(
        "input a, b; internal N: int 0..5 = 0; initial step 1 { N := N + 1 on activation; } step 2;"
        "transition t1: 1 -> 2 when a; transition t2: 2 -> 1 when b;");
    run(chart, "a");
    EXPECT_EQ(value(chart, "N"), 1);
    run(chart, "b");
    EXPECT_EQ(value(chart, "N"), 2);
}

TEST(Clearing, NeedsAllStepsUpstreamAndActivatesAllDownstream) {
    Play chart = play(
        "input a, b, c; initial step 1; step 2; step 3; step 4; step 5;"
        "transition split: 1 -> 2, 3 when a; transition on: 3 -> 4 when b;"
        "transition join: 2, 4 -> 5 when c;");
    run(chart, "a");
    EXPECT_EQ(situation(chart), "2 3");
    run(chart, "c");
    EXPECT_EQ(situation(chart), "2 3");
    run(chart, "b");
    EXPECT_EQ(situation(chart), "2 4");
    run(chart, "c");
    EXPECT_EQ(situation(chart), "5");
}

TEST(Clearing, AlternativesThatAreNotExclusiveAllFire) {
    Play chart = play(
        "input a, b; initial step 1; step 2; step 3;"
        "transition t1: 1 -> 2 when a; transition t2: 1 -> 3 when b;");
    const Cycle cycle = run(chart, "a b");
    EXPECT_EQ(fired(chart, cycle), "; t1 t2; ; ");
    EXPECT_EQ(situation(chart), "2 3");
}

TEST(Clearing, TransitionsFireTogetherFromTheOldSituation) {
    // If t1 were cleared before t2 was evaluated, X1 would be false at the evaluation of t2.
    Play chart = play(
        "input a; initial step 1; step 2; initial step 3; step 4;"
        "transition t1: 1 -> 2 when a; transition t2: 3 -> 4 when a && X1;",
        every_cycle);
    run(chart);
    run(chart, "a");
    EXPECT_EQ(situation(chart), "2 4");
}

TEST(Clearing, ASinkTransitionEmptiesTheChart) {
    Play chart = play("input a; initial step 1; transition t1: 1 -> when a;");
    run(chart, "a");
    EXPECT_EQ(situation(chart), "");
}

TEST(RuleFive, AStepActivatedAndDeactivatedAtOnceStaysActiveAndRunsNoAction) {
    Play chart = play(
        "input a; internal ON: int 0..9 = 0, OFF: int 0..9 = 0; initial step 1; initial step 2"
        "{ ON := ON + 1 on activation; OFF := OFF + 1 on deactivation; } step 3;"
        "transition t1: 1 -> 2 when a; transition t2: 2 -> 3 when a;",
        every_cycle);
    run(chart);
    EXPECT_EQ(value(chart, "ON"), 1);
    run(chart, "a");
    EXPECT_EQ(situation(chart), "2 3");
    EXPECT_EQ(value(chart, "ON"), 1);
    EXPECT_EQ(value(chart, "OFF"), 0);
}

TEST(RuleFive, AStepThatStaysActiveDoesNotRestartItsTimeCondition) {
    Play chart = play(
        "input a; initial step 1; step 2; transition again: 1 -> 1 when a;"
        "transition on: 1 -> 2 when 3s/X1;",
        every_cycle);
    run(chart);
    wait(chart, 2000);
    run(chart, "a");
    wait(chart, 1000);
    run(chart);
    EXPECT_EQ(situation(chart), "2");
}

TEST(StabilitySearch, TransientStepsGiveNoOutputButStore) {
    Play chart = play(
        "input a; output A, B; internal N: int 0..9 = 0; initial step 1; step 2 { A; N := N + 1 on activation; }"
        "step 3 { B; } transition t1: 1 -> 2 when a; transition t2: 2 -> 3 when true;");
    const Cycle cycle = run(chart, "a");
    EXPECT_EQ(fired(chart, cycle), "; t1; t2; ; ");
    EXPECT_TRUE(cycle.stable);
    EXPECT_EQ(outputs(chart), "B");
    EXPECT_EQ(value(chart, "N"), 1);
}

TEST(EveryCycle, WritesOutputsInTransientSituationsToo) {
    Play chart = play(
        "input a; output A, B; initial step 1; step 2 { A; } step 3 { B; }"
        "transition t1: 1 -> 2 when a; transition t2: 2 -> 3 when true;",
        every_cycle);
    run(chart, "a");
    EXPECT_FALSE(run(chart, "a").stable);
    EXPECT_EQ(outputs(chart), "A");
    run(chart);
    EXPECT_EQ(outputs(chart), "B");
    EXPECT_TRUE(run(chart).stable);
}

TEST(StabilitySearch, TheInitialSituationIsStabilisedBeforeTheFirstOutput) {
    Play chart = play("output A, B; initial step 1 { A; } step 2 { B; } transition t1: 1 -> 2 when true;");
    run(chart);
    EXPECT_EQ(outputs(chart), "B");
}

TEST(StabilitySearch, AnAssignationConditionFollowsItsInputWhileTheSituationStays) {
    Play chart = play("input a; output O; initial step 1 { O if a; }");
    run(chart, "a");
    EXPECT_EQ(outputs(chart), "O");
    run(chart);
    EXPECT_EQ(outputs(chart), "");
}

TEST(TotalInstability, IsReportedWithItsCycleOfSituations) {
    Play chart = play(
        "input a; initial step 0; step 1; step 2; transition t0: 0 -> 1 when a;"
        "transition t1: 1 -> 2 when a; transition t2: 2 -> 1 when true; output O;");
    EXPECT_TRUE(run(chart).endless.empty());
    const Cycle cycle = run(chart, "a");
    ASSERT_EQ(cycle.endless.size(), 2U);
    EXPECT_NE(cycle.endless[0], cycle.endless[1]);
    for (const std::vector<bool>& situation : cycle.endless) EXPECT_FALSE(situation[0]);
    EXPECT_FALSE(cycle.stable);
}

TEST(TotalInstability, ASourceTransitionOnALevelNeverStabilises) {
    Play chart = play("input a; step 1; transition t0: -> 1 when a;");
    EXPECT_EQ(run(chart, "a").endless, (std::vector<std::vector<bool>>{{true}}));
}

TEST(TotalInstability, LongFiniteCountIsNotReported) {
    Play chart = play(
        "internal N: int 0..100 = 0; initial step 1; step 2 { N := N + 1 on activation; }"
        "transition t1: 1 -> 2 when N < 100; transition t2: 2 -> 1 when true;");
    const Cycle cycle = run(chart);
    EXPECT_TRUE(cycle.endless.empty());
    EXPECT_TRUE(cycle.stable);
    EXPECT_EQ(value(chart, "N"), 100);
}

TEST(TotalInstability, TooLongAnInstantIsAborted) {
    Play chart = play(
        "internal N: int 0..2000 = 0, M: int 0..2000 = 0; initial step 1;"
        "step 2 { N := (N + 1) % 2001 on activation; M := (M + (N + 1) / 2001) % 2001 on activation; }"
        "transition t1: 1 -> 2 when true; transition t2: 2 -> 1 when true;");
    const Cycle cycle = run(chart);
    EXPECT_TRUE(cycle.gave_up);
    EXPECT_FALSE(cycle.stable);
    EXPECT_TRUE(cycle.endless.empty());
}

TEST(StoredActions, ReadOldValuesOnly) {
    Play chart = play(
        "input a; internal P: int 0..9 = 1, Q: int 0..9 = 2; initial step 1;"
        "step 2 { P := Q on activation; Q := P on activation; } transition t1: 1 -> 2 when a;");
    run(chart, "a");
    EXPECT_EQ(value(chart, "P"), 2);
    EXPECT_EQ(value(chart, "Q"), 1);
}

TEST(StoredActions, RunOnDeactivationAsTheStepIsLeft) {
    Play chart = play(
        "input a; internal N: int 0..9 = 0; initial step 1 { N := 7 on deactivation; } step 2;"
        "transition t1: 1 -> 2 when a;");
    run(chart);
    EXPECT_EQ(value(chart, "N"), 0);
    run(chart, "a");
    EXPECT_EQ(value(chart, "N"), 7);
}

TEST(StoredActions, OnOutputsReachThePlantWithTheOtherOutputs) {
    // Step 2 sets LOCK and step 3 resets it within one stability search, so the plant never receives its value true.
    Play chart = play(
        "input a; output LOCK, O; initial step 1; step 2 { LOCK := true on activation; }"
        "step 3 { LOCK := false on activation; O; } transition t1: 1 -> 2 when a; transition t2: 2 -> 3 when true;");
    run(chart, "a");
    EXPECT_EQ(outputs(chart), "O");
}

TEST(StoredActions, OnOutputsHoldUntilTheyAreStoredAgain) {
    Play chart = play(
        "input a, b; output LOCK; output SPEED: int 0..3; initial step 1; step 2 { LOCK := true on activation;"
        "SPEED := 2 on activation; } step 3; transition t1: 1 -> 2 when a; transition t2: 2 -> 3 when b;");
    run(chart, "a");
    run(chart, "b");
    EXPECT_EQ(situation(chart), "3");
    EXPECT_EQ(outputs(chart), "LOCK SPEED=2");
}

TEST(StoredActions, TwoValuesForOneVariableInOneEvolutionAreARace) {
    Play chart = play(
        "input a; internal N: int 0..9 = 0; initial step 1 { N := 1 on deactivation; }"
        "step 2 { N := 2 on activation; } transition t1: 1 -> 2 when a;");
    const Cycle cycle = run(chart, "a");
    ASSERT_TRUE(cycle.race.has_value());
    EXPECT_EQ(chart.chart.variables[cycle.race->variable].name, "N");
    EXPECT_EQ(cycle.race->first.index, 0U);
    EXPECT_EQ(cycle.race->second.index, 1U);
}

TEST(StoredActions, SameValueStoredTwiceDoesNotRace) {
    Play chart = play(
        "input a; internal N: int 0..9 = 0, M: int 0..9 = 2; initial step 1 { N := M on deactivation; }"
        "step 2 { N := 2 on activation; } transition t1: 1 -> 2 when a;");
    EXPECT_FALSE(run(chart, "a").race.has_value());
    EXPECT_EQ(value(chart, "N"), 2);
}

TEST(StoredActions, InitialStepsCanRaceToo) {
    Play chart = play(
        "internal N: int 0..9 = 0; initial step 1 { N := 1 on activation; } initial step 2 { N := 2 on activation; }");
    EXPECT_TRUE(run(chart).race.has_value());
}

TEST(StoredActions, AValueOutsideTheRangeIsAFaultOfTheChart) {
    Play chart = play(
        "input a; internal N: int 0..2 = 2; initial step 1; step 2 { N := N + 1 on activation; }"
        "transition t1: 1 -> 2 when a;");
    const Cycle cycle = run(chart, "a");
    ASSERT_TRUE(cycle.fault.has_value());
    EXPECT_EQ(cycle.fault->kind, RunFault::Kind::OutOfRange);
    EXPECT_EQ(cycle.fault->value, 3);
    EXPECT_EQ(value(chart, "N"), 3);
}

TEST(StoredActions, DivisionByZeroIsAFaultOfTheChart) {
    Play chart = play(
        "input a; internal N: int 0..9 = 0, M: int 0..9 = 0; initial step 1; step 2 { N := 1 / M on activation; }"
        "transition t1: 1 -> 2 when a;");
    const Cycle cycle = run(chart, "a");
    ASSERT_TRUE(cycle.fault.has_value());
    EXPECT_EQ(cycle.fault->kind, RunFault::Kind::NoValue);
}

TEST(Conditions, ThatReadAContinuousOutputMeanItsEquation) {
    // In the transient situation {2} no output was written yet, but O is true in that situation.
    Play chart = play(
        "input a; output O; initial step 1; step 2 { O; } step 3; step 4; transition t1: 1 -> 2 when a;"
        "transition t2: 2 -> 3 when O; transition t3: 3 -> 4 when O;");
    run(chart, "a");
    EXPECT_EQ(situation(chart), "3");
}

TEST(Conditions, ThatReadAnOutputReadTheOutputsItDependsOn) {
    Play chart =
        play("input a, b; output O, P; initial step 1 { O if P && a; P if b; } step 2; transition t1: 1 -> 2 when O;");
    run(chart, "a");
    EXPECT_EQ(situation(chart), "1");
    run(chart, "a b");
    EXPECT_EQ(situation(chart), "2");
}

TEST(Conditions, ThatReadAStoredOutputReadTheImageBeforeTheEvolution) {
    Play chart = play(
        "input a; output LOCK; initial step 1; step 2 { LOCK := true on activation; } initial step 3; step 4;"
        "transition t1: 1 -> 2 when a; transition t2: 3 -> 4 when LOCK;",
        every_cycle);
    run(chart);
    run(chart, "a");
    EXPECT_EQ(situation(chart), "2 3");
    run(chart);
    EXPECT_EQ(situation(chart), "2 4");
}

TEST(Conditions, OnlyThoseOfEnabledTransitionsAreEvaluated) {
    Play chart = play(
        "input a; internal M: int 0..9 = 0; initial step 1; step 2; step 3;"
        "transition t1: 1 -> 2 when a; transition t2: 2 -> 3 when 1 / M == 1;");
    EXPECT_FALSE(run(chart).fault.has_value());
    const Cycle cycle = run(chart, "a");
    ASSERT_TRUE(cycle.fault.has_value());
    EXPECT_EQ(cycle.fault->kind, RunFault::Kind::NoValue);
}

TEST(TimeConditions, HoldFromTheirDurationOnWhileTheStepIsActive) {
    Play chart = play("input a; initial step 1; step 2; transition t1: 1 -> 2 when 3s/X1 && a;");
    run(chart);
    wait(chart, 2999);
    run(chart, "a");
    EXPECT_EQ(situation(chart), "1");
    wait(chart, 1);
    run(chart);
    wait(chart, 60000);
    run(chart, "a");
    EXPECT_EQ(situation(chart), "2");
    EXPECT_EQ(time_conditions(chart.chart, chart.state), std::vector{false});
}

TEST(TimeConditions, RestartIfTheStepIsReactivatedWithinOneInstant) {
    // The pulse chart generates one pulse every 5 s; the chart does not pulse continuously after
    // the first 5 s.
    Play chart = play("initial step 1; step 2; transition t1: 1 -> 2 when 5s/X1; transition t2: 2 -> 1 when true;");
    run(chart);
    wait(chart, 5000);
    const Cycle cycle = run(chart);
    EXPECT_TRUE(cycle.endless.empty());
    EXPECT_EQ(fired(chart, cycle), "t1; t2; ; ");
    wait(chart, 4999);
    EXPECT_EQ(fired(chart, run(chart)), "; ");
    wait(chart, 1);
    EXPECT_EQ(fired(chart, run(chart)), "t1; t2; ; ");
}

TEST(PartialCharts, EvolveSideBySideAndReadEachOther) {
    Play chart = play(
        "input a; initial step 1; step 2; transition t1: 1 -> 2 when a;"
        "partial G { initial step 1; step 3; transition t2: 1 -> 3 when X2; }");
    run(chart, "a");
    EXPECT_EQ(situation(chart), "2 3");
}

}  // namespace
}  // namespace grafverif
