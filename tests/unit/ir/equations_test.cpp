// SPDX-License-Identifier: MIT
#include "grafverif/ir/equations.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace grafverif {
namespace {

using Role = Equations::Role;

/// One step with a source transition, an output and a counter. The equations contain all elements that verify checks.
struct Small {
    Equations equations = {};
    Id<Equations::Variable> start = equations.variables.add({"START", Role::Input, {}, 0, {}});
    Id<Equations::Variable> lamp = equations.variables.add({"LAMP", Role::Output, {}, 0, {}});
    Id<Equations::Variable> count = equations.variables.add({"COUNT", Role::Internal, integer_type(0, 3), 0, {}});
    Id<Equations::Variable> active = equations.variables.add({"X_1", Role::Step, {}, 0, {}});
    Id<Equations::Variable> fires = equations.variables.add({"CF_t0", Role::FiringCondition, {}, 0, {}});
    Id<Equations::Variable> end = equations.variables.add({"T_X1_1s_Q", Role::TimerEnd, {}, 0, {}});

    Id<Expr> leaf(Id<Equations::Variable> variable) { return equations.exprs.leaf(Op::Variable, variable.index); }

    Small() {
        Exprs& exprs = equations.exprs;
        const Id<Expr> no = exprs.constant(false);
        equations.firings.push_back({fires, leaf(start), "t0", {}});
        equations.steps.push_back(
            {active, exprs.disjunction(leaf(fires), leaf(active)), leaf(fires), no, {"", "1"}, {}});
        equations.stored.push_back({count, leaf(count), no, leaf(count), no, {}});
        equations.timers.push_back({"T_X1_1s", active, end, 1000, 0, {}});
        equations.outputs.push_back({lamp, leaf(active), {}});
        equations.stable = exprs.negation(leaf(fires));
    }
};

TEST(VerifyEquations, FindsNothingInWellFormedOnes) {
    EXPECT_EQ(verify(Small{}.equations), std::vector<std::string>{});
}

TEST(VerifyEquations, NamesEachBrokenInvariant) {
    struct Case {
        const char* fault;
        void (*damage)(Small&);
    };
    for (const Case& one : std::vector<Case>{
             {"two variables are named `X_1`", [](Small& s) { s.equations.variables[s.fires].name = "X_1"; }},
             {"the initial value of `COUNT` is outside its range",
              [](Small& s) { s.equations.variables[s.count].initial = 4; }},
             {"a term reads a variable that does not exist",
              [](Small& s) { s.equations.exprs.leaf(Op::Variable, 99); }},
             {"a term has an operator that equations do not have",
              [](Small& s) { s.equations.exprs.leaf(Op::Step, 0); }},
             {"the firing condition of `t0` reads a firing condition",
              [](Small& s) { s.equations.firings[0].condition = s.leaf(s.fires); }},
             {"the value of `LAMP` reads a firing condition",
              [](Small& s) { s.equations.outputs[0].value = s.leaf(s.fires); }},
             {"the activity of `X_1` is not Boolean", [](Small& s) { s.equations.steps[0].next = s.leaf(s.count); }},
             {"the activity of `X_1` contains a type error",
              [](Small& s) {
                  s.equations.steps[0].next = s.equations.exprs.disjunction(
                      s.leaf(s.start), s.equations.exprs.conjunction(s.leaf(s.fires), s.leaf(s.count)));
              }},
             {"the activation of `1` is missing", [](Small& s) { s.equations.steps[0].activated = {}; }},
             {"the stored value of `COUNT` is not an integer",
              [](Small& s) { s.equations.stored[0].next = s.leaf(s.start); }},
             {"the race condition of `COUNT` is missing", [](Small& s) { s.equations.stored[0].race = {}; }},
             {"the timer `T_X1_1s` has no duration", [](Small& s) { s.equations.timers[0].rise_ms = 0; }},
             {"the condition `stable` is missing", [](Small& s) { s.equations.stable = {}; }},
             {"`LAMP` has no equation", [](Small& s) { s.equations.outputs.clear(); }},
             {"`X_1` has more than one equation", [](Small& s) { s.equations.steps.push_back(s.equations.steps[0]); }},
             {"`CF_t0` has an equation of a type that its role does not permit",
              [](Small& s) { s.equations.variables[s.fires].role = Role::Step; }},
         }) {
        SCOPED_TRACE(one.fault);
        Small small;
        one.damage(small);
        const std::vector<std::string> faults = verify(small.equations);
        EXPECT_NE(std::find(faults.begin(), faults.end(), one.fault), faults.end()) << ::testing::PrintToString(faults);
    }
}

}  // namespace
}  // namespace grafverif
