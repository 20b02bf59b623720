// SPDX-License-Identifier: MIT
// Tests `t1/v/t2` on inputs, steps and expressions, and delayed and time-limited actions.
#include <gtest/gtest.h>

#include "support/play.hpp"

namespace grafverif {
namespace {

/// Returns the outputs after `milliseconds` and a cycle with `inputs`.
std::string later(Play& play, std::int64_t milliseconds, std::string_view inputs = {}) {
    wait(play, milliseconds);
    run(play, inputs);
    return outputs(play);
}

TEST(TimeOfAnInput, CountsFromItsEdgesAndNeedsItToLast) {
    Play chart = play("input a; output O; initial step 1 { O if 3s/a/2s; }");
    EXPECT_EQ(later(chart, 0), "");
    EXPECT_EQ(later(chart, 1000, "a"), "");
    EXPECT_EQ(later(chart, 2999, "a"), "");
    EXPECT_EQ(later(chart, 1, "a"), "O");
    EXPECT_EQ(later(chart, 500), "O");
    EXPECT_EQ(later(chart, 1999), "O");
    EXPECT_EQ(later(chart, 1), "");
    EXPECT_EQ(later(chart, 0, "a"), "");
    EXPECT_EQ(later(chart, 2000), "");  // `a` was true for less than 3 s, which does not count
    EXPECT_EQ(later(chart, 1000), "");
}

TEST(TimeOfAnInput, ShortRiseDoesNotProlongTheFall) {
    Play chart = play("input a; output O; initial step 1 { O if 3s/a/2s; }");
    run(chart, "a");
    EXPECT_EQ(later(chart, 3000, "a"), "O");
    EXPECT_EQ(later(chart, 0), "O");
    EXPECT_EQ(later(chart, 1000, "a"), "O");
    EXPECT_EQ(later(chart, 500), "O");
    EXPECT_EQ(later(chart, 500), "");
}

TEST(TimeOfAnInput, EndsAtOnceWithoutAFallTime) {
    Play chart = play("input a; output O; initial step 1 { O if 3s/a; } step 2; transition t1: 1 -> 2 when 3s/a;");
    run(chart, "a");
    EXPECT_EQ(later(chart, 3000), "");
    EXPECT_EQ(situation(chart), "1");  // a falls when 3 s have elapsed, so 3s/a never becomes true
}

TEST(TimeOfAnInput, StartsAtOnceWithoutARiseTime) {
    Play chart = play("input a; output O; initial step 1 { O if a/2s; }");
    EXPECT_EQ(later(chart, 0), "");
    EXPECT_EQ(later(chart, 100, "a"), "O");
    EXPECT_EQ(later(chart, 5000), "O");
    EXPECT_EQ(later(chart, 1999), "O");
    EXPECT_EQ(later(chart, 1), "");
}

TEST(TimeOfAStep, LastsAfterItIsLeft) {
    Play chart = play(
        "input a; initial step 1; step 2; initial step 8; step 9; step 10;"
        "transition t1: 1 -> 2 when a; transition t8: 8 -> 9 when 3s/X1/2s && X2;"
        "transition t9: 9 -> 10 when !(3s/X1/2s);");
    run(chart);
    wait(chart, 3000);
    run(chart, "a");
    EXPECT_EQ(situation(chart), "2 9");
    wait(chart, 1999);
    run(chart);
    EXPECT_EQ(situation(chart), "2 9");
    wait(chart, 1);
    run(chart);
    EXPECT_EQ(situation(chart), "2 10");
}

TEST(TimeOfATerm, CountsItsLevelAsAWhole) {
    Play chart = play(
        "input a; output O; initial step 1; step 2; initial step 8 { O if 2s/(X1 || X2); }"
        "transition t1: 1 -> 2 when rise(a); transition t2: 2 -> when fall(a);");
    run(chart);
    EXPECT_EQ(later(chart, 1000, "a"), "");  // step 1 is left for step 2, and the term remains true
    EXPECT_EQ(later(chart, 1000, "a"), "O");
    EXPECT_EQ(later(chart, 0), "");
}

TEST(DelayedActions, BeginWhenTheirStepHasBeenActiveForTheDelay) {
    Play chart = play(
        "input a; output O; initial step 1 { O after 3s; } step 2; transition t1: 1 -> 2 when a;"
        "transition t2: 2 -> 1 when true;");
    run(chart);
    EXPECT_EQ(later(chart, 2999), "");
    EXPECT_EQ(later(chart, 1), "O");
    EXPECT_EQ(later(chart, 0, "a"), "O");  // the chart is totally unstable while a is true: no output is written
}

TEST(TimeLimitedActions, EndAfterTheirLimitAndRestartWithTheStep) {
    Play chart = play(
        "input a; output O; initial step 1 { O for 5s; } step 2;"
        "transition t1: 1 -> 2 when rise(a); transition t2: 2 -> 1 when fall(a);");
    run(chart);
    EXPECT_EQ(outputs(chart), "O");
    EXPECT_EQ(later(chart, 4999), "O");
    EXPECT_EQ(later(chart, 1), "");
    EXPECT_EQ(later(chart, 0, "a"), "");
    EXPECT_EQ(later(chart, 0), "O");
}

TEST(TimeLimitedActions, WithADelayLastFromItsEndOn) {
    Play chart = play("output O; initial step 1 { O after 2s for 3s; }");
    run(chart);
    EXPECT_EQ(later(chart, 1999), "");
    EXPECT_EQ(later(chart, 1), "O");
    EXPECT_EQ(later(chart, 2999), "O");
    EXPECT_EQ(later(chart, 1), "");
}

}  // namespace
}  // namespace grafverif
