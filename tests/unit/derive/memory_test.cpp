// SPDX-License-Identifier: MIT
// Tests the values that equations store: previous values, levels, timers.
#include <gtest/gtest.h>

#include <sstream>

#include "support/play.hpp"
#include "syntax/print/equations.hpp"

namespace grafverif {
namespace {

std::string notation(std::string_view text) {
    std::ostringstream out;
    print_equations(out, equations(text));
    return std::move(out).str();
}

TEST(Memory, AnEdgeComparesWithThePreviousValue) {
    EXPECT_EQ(
        notation("input a; initial step 1; step 2;"
                 "transition t0: 1 -> 2 when rise(a); transition t1: 2 -> 1 when fall(a) || rise(!a) || rise(X2);"),
        R"(Equations of chart

(a) Firing conditions
CF_t0 = X_1 and a and not P_a
CF_t1 = X_2 and ((P_a and not a) or (X_2 and not P_X_2))

(b) Step activities
X_1 = CF_t1 or (X_1 and not CF_t0)
X_2 = CF_t0 or (X_2 and not CF_t1)

(e) Previous values
P_a = a
P_X_2 = X_2
)");
}

TEST(Memory, ATimeOverAnythingButAStepWatchesItsLevel) {
    EXPECT_EQ(notation("input a, b; output O, R; initial step 1 { O if 2s/X1/4s; R after 3s for 5s; }"
                       "transition t0: 1 -> when 3s/a && a/2s && 1s/(a && b)/2s;"),
              R"(Equations of chart

(a) Firing conditions
CF_t0 = X_1 and a and T_a_3s_Q and (a or T_a_0s_2s_Q) and T_2_1s_2s_Q

(b) Step activities
X_1 = X_1 and not CF_t0

(c) Output values
V_a = a
V_2 = a and b
T_X1_2s_4s = X_1
T_X1_3s = X_1
T_X1_8s = X_1
T_a_3s = V_a
T_a_0s_2s = V_a
T_2_1s_2s = V_2
O = X_1 and T_X1_2s_4s_Q
R = X_1 and T_X1_3s_Q and not T_X1_8s_Q
)");
}

TEST(Memory, EventsAndClearingTriggerStoredActions) {
    EXPECT_EQ(notation("input a; internal N: int 0..9 = 0; initial step 1 { N := N + 1 on event rise(a); }"
                       "transition t0: 1 -> 1 when N == 3 do N := 0;"),
              R"(Equations of chart

(a) Firing conditions
CF_t0 = X_1 and N == 3

(b) Step activities
X_1 = CF_t0 or (X_1 and not CF_t0)

(s) Stored actions
N = X_1 and a and not P_a ? N + 1 : CF_t0 ? 0 : N

(s) Stored actions, races: two actions would store different values
N = X_1 and a and not P_a and CF_t0 and N + 1 != 0

(e) Previous values
P_a = a
)");
}

/// Returns `S first, V_b after`: the stored previous values and levels, in order. `first` marks a variable with a
/// separate value after the first evolution.
std::string kept_in(const Equations& equations) {
    std::string text;
    for (const Kept& each : kept(equations))
        text += (text.empty() ? "" : ", ") + equations.variables[each.variable].name +
                (each.first.valid() ? " first" : "") + (each.after ? " after" : "");
    return text;
}

TEST(Memory, OneListContainsTheStateBetweenCycles) {
    const char* const rest =
        "step 2; transition t0: 1 -> 2 when rise(a); transition t1: 2 -> 1 when 3s/b do S := false;";
    const Equations acts =
        equations("input a, b; output S; initial step 1 { S := true on activation; }" + std::string(rest));
    EXPECT_EQ(kept_in(acts), "S first, P_a first, X_1, X_2, V_b first after");
    EXPECT_TRUE(acts_at_first(acts));
    EXPECT_EQ(remembered(acts).size(), 2U);
    const Equations idle =
        equations("input a, b; output S; initial step 1 { S := true on deactivation; }" + std::string(rest));
    EXPECT_EQ(kept_in(idle), "S, P_a first, X_1, X_2, V_b first after");
    EXPECT_FALSE(acts_at_first(idle));
}

TEST(Memory, OnlyPossibleFaultsAreListed) {
    const std::string chart =
        "input a; internal N: int 0..9 = 0; initial step 1 { N := 1 on deactivation; }"
        "step 2 { N := 2 on activation; } transition t0: 1 -> 2 when a do N := ";
    const Equations races = equations(chart + "1;");
    ASSERT_EQ(faults(races).size(), 1U);
    EXPECT_EQ(races.variables[faults(races)[0].variable].name, "N");
    EXPECT_FALSE(is_false(races.exprs, faults(races)[0].condition));
    EXPECT_TRUE(is_false(races.exprs, faults(races)[0].first));
    EXPECT_TRUE(faults(equations("input a; internal N: int 0..9 = 0; initial step 1 { N := 1 on deactivation; }"
                                 "transition t0: 1 -> 1 when a;"))
                    .empty());
}

}  // namespace
}  // namespace grafverif
