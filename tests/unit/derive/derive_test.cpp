// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "support/play.hpp"
#include "support/run_equations.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {
namespace {

std::string text(const Equations& equations, Id<Expr> term) {
    return expr_text(equations.exprs, term, plain_spelling, [&](std::ostream& out, const Expr& leaf) {
        out << equations.variables[Id<Equations::Variable>{static_cast<std::uint32_t>(leaf.value)}].name;
    });
}

std::string output(const Equations& equations, std::string_view name) {
    for (const Equations::Output& one : equations.outputs)
        if (equations.variables[one.variable].name == name) return text(equations, one.value);
    return "no equation";
}

std::string firing(const Equations& equations, std::size_t k) {
    return text(equations, equations.firings[k].condition);
}

std::vector<std::string> names(const Equations& equations) {
    std::vector<std::string> result;
    for (const Equations::Variable& variable : equations.variables) result.push_back(variable.name);
    return result;
}

TEST(Derive, NamesVariablesAfterStepsTransitionsAndTimers) {
    const Equations e = equations(
        "input a; output O; initial step 1; step 2; transition T0: 1 -> 2 when 3s/X1;"
        "partial G { initial step 1; step 7; transition t9: 1 -> 7 when 250ms/X1; }");
    EXPECT_EQ(names(e), (std::vector<std::string>{"a", "O", "X_1", "X_2", "X_G_1", "X_G_7", "CF_T0", "CF_t9",
                                                  "T_X1_3s_Q", "T_G_X1_250ms_Q"}));
    EXPECT_EQ(e.timers[0].name, "T_X1_3s");
    EXPECT_EQ(e.timers[1].name, "T_G_X1_250ms");
    EXPECT_EQ(e.steps[3].step.text(), "G.7");
}

TEST(Derive, GivesATakenNameANumber) {
    const Equations e = equations(
        "input CF_t0, T_X1_3s; initial step 1; step 2; transition t0: 1 -> 2 when 3s/X1 && CF_t0 && T_X1_3s;");
    EXPECT_EQ(names(e), (std::vector<std::string>{"CF_t0", "T_X1_3s", "X_1", "X_2", "CF_t0_2", "T_X1_3s_2_Q"}));
    EXPECT_EQ(e.timers[0].name, "T_X1_3s_2");
}

TEST(Derive, MakesOneTimerPerStepAndDuration) {
    const Equations e = equations(
        "initial step 1; step 2; step 3; transition t0: 1 -> 2 when 3s/X1; transition t1: 1 -> 3 when 3000ms/X1;"
        "transition t2: 2 -> 3 when 3s/X1 || 4s/X1;");
    ASSERT_EQ(e.timers.size(), 2U);
    EXPECT_EQ(firing(e, 1), "X_1 and T_X1_3s_Q");
    EXPECT_EQ(e.timers[1].rise_ms, 4000);
}

TEST(Derive, OmitsUnusedTimers) {
    const Equations e = equations("initial step 1; step 2; transition t0: 1 -> 2 when 3s/X1 || true;");
    EXPECT_TRUE(e.timers.empty());
    EXPECT_EQ(firing(e, 0), "X_1");
}

TEST(Derive, FollowsEquationElevenForEveryKindOfTransition) {
    const Equations e = equations(
        "input a; initial step 1; initial step 2; step 3; transition join: 1, 2 -> 3 when a;"
        "transition src: -> 1 when a; transition sink: 3 -> when true;");
    EXPECT_EQ(firing(e, 0), "X_1 and X_2 and a");
    EXPECT_EQ(firing(e, 1), "a");
    EXPECT_EQ(firing(e, 2), "X_3");
}

TEST(Derive, FollowsEquationTwelveForEveryKindOfStep) {
    const Equations e = equations(
        "input a; initial step 1; step 2; step 3; transition t0: 1 -> 2 when a; transition t1: 1 -> 2, 3 when !a;"
        "transition t2: 2 -> 2 when a;");
    EXPECT_EQ(text(e, e.steps[0].next), "X_1 and not (CF_t0 or CF_t1)");
    EXPECT_EQ(text(e, e.steps[1].next), "CF_t0 or CF_t1 or CF_t2 or (X_2 and not CF_t2)");
    EXPECT_EQ(text(e, e.steps[2].next), "CF_t1 or X_3");
    EXPECT_EQ(text(e, e.steps[0].activated), "false");
    EXPECT_EQ(text(e, e.steps[1].activated), "(CF_t0 or CF_t1 or CF_t2) and not X_2");
    EXPECT_EQ(text(e, e.steps[1].deactivated), "X_2 and CF_t2 and not (CF_t0 or CF_t1 or CF_t2)");
    EXPECT_EQ(text(e, e.stable), "not (CF_t0 or CF_t1 or CF_t2)");
}

TEST(Derive, ASituationIsNotStableIfAConditionIsTrueOnceEdgesAreOver) {
    const std::string steps = "input a, b; internal N: int 0..9 = 0; initial step 1; step 2; ";
    const Equations positive = equations(steps + "transition t0: 1 -> 2 when rise(a) && b || fall(a);");
    EXPECT_EQ(text(positive, positive.stable), "not CF_t0");
    const Equations negative = equations(steps + "transition t0: 1 -> 2 when b && !rise(a);");
    EXPECT_EQ(text(negative, negative.stable), "not (CF_t0 or (X_1 and b))");
    const Equations partial = equations(steps + "transition t0: 1 -> 2 when (rise(a) || 2 / N == 1) && b;");
    EXPECT_EQ(text(partial, partial.stable), "not (CF_t0 or (X_1 and 2 / N == 1 and b))");
    const Equations event =
        equations("input a, b; internal N: int 0..9 = 0; initial step 1 { N := 1 on event rise(a); }");
    EXPECT_EQ(text(event, event.stable), "not (X_1 and a and not P_a)");
}

TEST(Derive, FollowsEquationThirteenForEveryOutput) {
    const Equations e = equations(
        "input a, b; output O, P, UNUSED; initial step 1 { O; P if a && b; } step 2 { O if a; O if b; }"
        "transition t0: 1 -> 2 when a;");
    EXPECT_EQ(output(e, "O"), "X_1 or (X_2 and a) or (X_2 and b)");
    EXPECT_EQ(output(e, "P"), "X_1 and a and b");
    EXPECT_EQ(output(e, "UNUSED"), "false");
}

TEST(Derive, ReplacesAnOutputReadInAConditionByItsEquation) {
    const Equations e = equations(
        "input a; output O, P; initial step 1 { P if O || a; } step 2 { O if a; }"
        "transition t0: 1 -> 2 when !O; transition t1: 2 -> 1 when P;");
    EXPECT_EQ(output(e, "P"), "X_1 and ((X_2 and a) or a)");
    EXPECT_EQ(firing(e, 0), "X_1 and not (X_2 and a)");
    EXPECT_EQ(firing(e, 1), "X_2 and X_1 and ((X_2 and a) or a)");
}

TEST(Derive, KeepsAStoredOutputReadInACondition) {
    const Equations e = equations(
        "output LOCK; initial step 1; step 2 { LOCK := true on activation; }"
        "transition t0: 1 -> 2 when !LOCK;");
    EXPECT_EQ(firing(e, 0), "X_1 and not LOCK");
    EXPECT_EQ(output(e, "LOCK"), "no equation");
    EXPECT_EQ(text(e, e.stored[0].next), "(CF_t0 and not X_2) or LOCK");
}

TEST(Derive, WritesBooleanConstantsAsSetAndReset) {
    const Equations e = equations(
        "input a; internal M = false; initial step 1 { M := false on deactivation; } step 2 { M := true on activation; "
        "}"
        "step 3; transition t0: 1 -> 3 when a; transition t1: 3 -> 2 when a;");
    EXPECT_EQ(text(e, e.stored[0].next), "(CF_t1 and not X_2) or (M and not (X_1 and CF_t0))");
    EXPECT_EQ(text(e, e.stored[0].race), "X_1 and CF_t0 and CF_t1 and not X_2");
}

TEST(Derive, WritesOtherValuesAsAChainOfChoices) {
    const Equations e = equations(
        "input a; internal N: int 0..9 = 0; initial step 1 { N := N + 1 on deactivation; }"
        "step 2 { N := 0 on activation; N := N + 1 on deactivation; }"
        "transition t0: 1 -> 2 when a; transition t1: 2 -> 1 when a;");
    EXPECT_EQ(text(e, e.stored[0].next),
              "(X_1 and CF_t0 and not CF_t1) or (X_2 and CF_t1 and not CF_t0) ? N + 1 : "
              "CF_t0 and not X_2 ? 0 : N");
}

TEST(Derive, EqualValuesDoNotRace) {
    const Equations e = equations(
        "input a; internal N: int 0..9 = 0; initial step 1 { N := 3 on deactivation; } step 2 { N := 3 on activation; }"
        "transition t0: 1 -> 2 when a;");
    EXPECT_EQ(text(e, e.stored[0].race), "false");
}

TEST(Derive, ARaceOfTermsAsksWhetherTheirValuesDiffer) {
    const Equations e = equations(
        "input a; internal N: int 0..9 = 0; initial step 1 { N := N + 1 on deactivation; } step 2 { N := 3 on "
        "activation; }"
        "transition t0: 1 -> 2 when a;");
    EXPECT_EQ(text(e, e.stored[0].race), "X_1 and CF_t0 and not X_2 and N + 1 != 3");
}

TEST(Derive, ActivationAndDeactivationOfOneStepNeverRace) {
    const Equations e = equations(
        "input a; internal N: int 0..9 = 0; initial step 1; step 2 { N := 1 on activation; N := 0 on deactivation; }"
        "transition t0: 1 -> 2 when a; transition t1: 2 -> 1 when a;");
    EXPECT_EQ(text(e, e.stored[0].race), "false");
}

TEST(Derive, FirstEvolutionRunsStoredActionsOfInitialSteps) {
    const Equations e = equations(
        "input a; internal N: int 0..9 = 4, M: int 0..9 = 0; initial step 1 { N := N + 1 on activation; } "
        "step 2 { N := 0 on activation; M := 1 on activation; } transition t0: 1 -> 2 when a;");
    EXPECT_EQ(text(e, e.stored[0].first), "N + 1");
    EXPECT_TRUE(e.stored[0].writes[0].initial);
    EXPECT_FALSE(e.stored[0].writes[1].initial);
    EXPECT_EQ(text(e, e.stored[1].first), "M");
    EXPECT_EQ(text(e, e.stored[1].first_race), "false");
}

TEST(Derive, TheFirstEvolutionCanRace) {
    const Equations e = equations(
        "internal N: int 0..9 = 0; initial step 1 { N := N + 1 on activation; } initial step 2 { N := 0 on activation; "
        "}");
    EXPECT_EQ(text(e, e.stored[0].first_race), "N + 1 != 0");
}

TEST(Derive, AnInternalNeverWrittenHasNoEquation) {
    const Equations e =
        equations("internal N: int 0..9 = 4; initial step 1; step 2; transition t0: 1 -> 2 when N == 4;");
    EXPECT_TRUE(e.stored.empty());
    EXPECT_EQ(e.variables[Id<Equations::Variable>{0}].initial, 4);
    EXPECT_EQ(firing(e, 0), "X_1 and N == 4");
}

TEST(Refused, OutputsThatReadEachOther) {
    EXPECT_EQ(
        refusals("output A, B, C; initial step 1 { A if B; B if C; C if !B; }"),
        (std::vector<std::string>{
            "[output-cycle] the output `B` depends on itself (`B` reads `C` reads `B`); remove one of these outputs "
            "from an assignation condition, which is expanded with the equation of each output that it reads"}));
    EXPECT_EQ(refusals("output A; initial step 1 { A if !A; }").size(), 1U);
}

TEST(Refused, EdgesInContextsWithoutAnInstant) {
    EXPECT_EQ(
        refusals("input a; output O; initial step 1 { O if fall(a); }"),
        std::vector<std::string>{"[edge-in-assignation] the assignation condition of `O` contains an edge, which is "
                                 "not a lasting state; store the output `on event`, or remove the edge operator"});
    EXPECT_EQ(refusals("input a; initial step 1; transition t0: 1 -> 1 when 3s/(a && rise(a));"),
              std::vector<std::string>{"[edge-under-time] an edge lasts for one evolution and has no duration; apply "
                                       "the time condition to the variable itself"});
    EXPECT_EQ(refusals("input a; initial step 1; transition t0: 1 -> 1 when rise(a && !fall(a));"),
              std::vector<std::string>{
                  "[edge-of-edge] an edge operator is applied to an edge; apply it to the variable itself"});
    for (const char* event : {"a", "a || rise(a)", "!rise(a)", "3s/X1"})
        EXPECT_EQ(
            refusals(std::string("input a; internal M = false; initial step 1 { M := true on event ") + event + "; }")
                .size(),
            1U)
            << event;
}

TEST(Refused, TermsThatSubstitutionBlowsUp) {
    std::string chart = "input a, b; output ";
    for (int k = 0; k < 25; ++k) chart += (k > 0 ? ", O" : "O") + std::to_string(k);
    chart += "; initial step 1 { O0 if a;";
    for (int k = 1; k < 25; ++k) {
        const std::string before = "O" + std::to_string(k - 1);
        chart += "O" + std::to_string(k) + " if (" + before + " && a) == (" + before + " && b);";
    }
    const std::vector<std::string> messages = refusals(chart + "}");
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_TRUE(messages[0].starts_with("[too-large] the equation of output `O")) << messages[0];
}

TEST(Refused, TermsThatSubstitutionNestsTooDeep) {
    std::string chart = "input a; output O0";
    for (int k = 1; k < 3000; ++k) chart += ", O" + std::to_string(k);
    chart += "; initial step 1 { O0 if a;";
    for (int k = 1; k < 3000; ++k) chart += "O" + std::to_string(k) + " if !O" + std::to_string(k - 1) + ";";
    const std::vector<std::string> messages = refusals(chart + "}");
    ASSERT_FALSE(messages.empty());
    EXPECT_TRUE(messages[0].starts_with("[too-large]") && messages[0].find("deeper") != std::string::npos)
        << messages[0];
}

TEST(Refused, TooManyDifferentValuesForOneVariable) {
    std::string chart = "internal N: int 0..2000 = 0; initial step s {";
    for (int k = 0; k < 1001; ++k) chart += "N := " + std::to_string(k) + " on activation;";
    const std::vector<std::string> messages = refusals(chart + "}");
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_TRUE(messages[0].starts_with("[too-large] more than 1000 different values are stored in `N`"))
        << messages[0];
}

TEST(Derive, KeepsConstraintsAsAssumptionsOnTheInputs) {
    const Equations e = equations("input a, b; constraint !(a && b); initial step 1; constraint a || b;");
    ASSERT_EQ(e.assumptions.size(), 2U);
    EXPECT_EQ(text(e, e.assumptions[0].condition), "not (a and b)");
    EXPECT_EQ(text(e, e.assumptions[1].condition), "a or b");
}

TEST(Derive, ARaceAmongManyConstantsStaysSmall) {
    std::string chart = "input a; internal N: int 0..2000 = 0; initial step s;";
    for (int k = 0; k < 1000; ++k)
        chart += "step s" + std::to_string(k) + " { N := " + std::to_string(k) + " on activation; } transition t" +
                 std::to_string(k) + ": s -> s" + std::to_string(k) + " when a;";
    const Equations e = equations(chart);
    EXPECT_LT(text(e, e.stored[0].race).size(), 1000U * 12U * 40U);
}

}  // namespace
}  // namespace grafverif
