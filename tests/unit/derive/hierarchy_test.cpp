// SPDX-License-Identifier: MIT
// Tests hierarchy in the equations: macro-steps, enclosing steps, forcing orders.
#include <gtest/gtest.h>

#include <sstream>

#include "support/play.hpp"
#include "syntax/print/equations.hpp"

namespace grafverif {
namespace {

std::string equations_of(std::string_view text) {
    std::ostringstream out;
    print_equations(out, equations(text));
    return std::move(out).str();
}

TEST(HierarchyEquations, OfAMacroStepAreThoseOfItsExpansion) {
    EXPECT_EQ(equations_of("input a, b; initial step 1; macro step M expands E; transition t1: 1 -> M when a;"
                           "transition t2: M -> 1 when b; expansion E { entry step 10; exit step 11;"
                           "transition e1: 10 -> 11 when a; }"),
              R"(Equations of chart

(a) Firing conditions
CF_t1 = X_1 and a
CF_t2 = X_E_11 and b
CF_e1 = X_E_10 and a

(b) Step activities
X_1 = CF_t2 or (X_1 and not CF_t1)
X_M = CF_t1 or (X_E_10 and not CF_e1) or CF_e1 or (X_E_11 and not CF_t2)
X_E_10 = CF_t1 or (X_E_10 and not CF_e1)
X_E_11 = CF_e1 or (X_E_11 and not CF_t2)
)");
}

TEST(HierarchyEquations, OfEnclosedStepsAskForTheEnclosingStep) {
    EXPECT_EQ(equations_of("input a, b; initial step 1; enclosing step 6 encloses G; transition t1: 1 -> 6 when a;"
                           "transition t2: 6 -> 1 when b; partial G { linked step 20; step 21;"
                           "transition g1: 20 -> 21 when a; transition g2: -> 20 when b; }"),
              R"(Equations of chart

(a) Firing conditions
CF_t1 = X_1 and a
CF_t2 = X_6 and b
CF_g1 = X_G_20 and a
CF_g2 = X_6 and b

(b) Step activities
X_1 = CF_t2 or (X_1 and not CF_t1)
X_6 = CF_t1 or (X_6 and not CF_t2)
X_G_20 = (CF_t1 or (X_6 and not CF_t2)) and (CF_g2 or (X_G_20 and not CF_g1) or (CF_t1 and not X_6))
X_G_21 = (CF_t1 or (X_6 and not CF_t2)) and (CF_g1 or X_G_21)
)");
}

TEST(HierarchyEquations, OfForcedStepsGiveOrdersPriority) {
    EXPECT_EQ(equations_of("input a; initial step 1; step 2 { force G := {21}; } initial step 3;"
                           "step 4 { force G := {*}; } transition t1: 1 -> 2 when a; transition t2: 3 -> 4 when a;"
                           "partial G { initial step 20; step 21; transition g1: 20 -> 21 when a; }"),
              R"(Equations of chart

(a) Firing conditions
CF_t1 = X_1 and a
CF_t2 = X_3 and a
CF_g1 = X_G_20 and not X_2 and not X_4 and a

(b) Step activities
X_1 = X_1 and not CF_t1
X_2 = CF_t1 or X_2
X_3 = X_3 and not CF_t2
X_4 = CF_t2 or X_4
X_G_20 = X_G_20 and not CF_g1 and not (CF_t1 or X_2)
X_G_21 = CF_t1 or X_2 or CF_g1 or X_G_21

(f) Conflicts of forcing orders
(CF_t1 or X_2) and (CF_t2 or X_4)
)");
}

TEST(HierarchyEquations, RefuseCyclesAndContradictions) {
    EXPECT_TRUE(refusals("initial step 1 { force G := {}; } partial G { initial step 2; step 3 { force H := {}; }"
                         "transition g: 2 -> 3 when true; } partial H { initial step 4 { force G := {*}; } }")
                    .front()
                    .starts_with("[forcing-cycle] "));
    EXPECT_TRUE(refusals("initial step 1; partial G { initial step 2 { force G := {2}; } }")
                    .front()
                    .starts_with("[forcing-cycle] "));
    EXPECT_TRUE(refusals("initial step 1 { force G := {}; force G := {INIT}; } partial G { initial step 2; }")
                    .front()
                    .starts_with("[forced-twice] "));
}

}  // namespace
}  // namespace grafverif
