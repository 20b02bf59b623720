// SPDX-License-Identifier: MIT
// Tests single controllers as transition systems, which are executed step by step.
#include "schedule/controller.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "schedule/ranges.hpp"
#include "support/play.hpp"
#include "support/run_transition_system.hpp"

namespace grafverif {
namespace {

/// Executes a system with named inputs in each step. All other inputs are false or the least value of their range.
struct Stepper {
    TransitionSystem system = {};
    SystemState state = {};

    void set(const std::map<std::string, std::int64_t>& inputs) {
        for (const auto& [name, value] : inputs) set_value(system, state, name, value);
    }
    /// Executes one cycle that reads `inputs`.
    void step(const std::map<std::string, std::int64_t>& inputs = {}) {
        set(inputs);
        state = next_state(system, state, [](std::string_view, Type type) { return type.low; });
    }
    std::int64_t operator[](const std::string& name) const {
        return value_of(system, state, system.instances[{0}].name + "." + name);
    }
    bool settled() const { return value_of(system, state, system.settled) != 0; }
};

/// Returns the controller at power-on.
Stepper power_on(std::string_view chart, ExecutionMode mode) {
    Stepper stepper{schedule_controller(equations(chart), mode)};
    EXPECT_EQ(verify(stepper.system), std::vector<std::string>{});
    stepper.state = first_state(stepper.system, [](std::string_view, Type type) { return type.low; });
    return stepper;
}

/// Returns the controller after a first evolution that read `first`.
Stepper start(std::string_view chart, ExecutionMode mode, const std::map<std::string, std::int64_t>& first = {}) {
    Stepper stepper = power_on(chart, mode);
    if (stepper.system.controllers.front().starts.valid()) stepper.step(first);
    return stepper;
}

std::vector<std::string> property_names(const TransitionSystem& system) {
    std::vector<std::string> names;
    for (const Property& property : system.properties) names.push_back(property.name);
    return names;
}

constexpr auto searching = ExecutionMode::StabilitySearch;
constexpr auto cyclic = ExecutionMode::EveryCycle;

TEST(ScheduleController, MakesOneCycleOfOneStep) {
    Stepper s = start(
        "input a; initial step 1; step 2; step 3; transition t1: 1 -> 2 when a; transition t2: 2 -> 3 when a;", cyclic);
    EXPECT_EQ(s["X_1"], 1);
    s.step({{"a", 1}});
    EXPECT_EQ(s["X_1"], 0);
    EXPECT_EQ(s["X_2"], 1);
    EXPECT_EQ(s["X_3"], 0) << "one evolution per cycle";
}

TEST(ScheduleController, WritesOutputsOnlyWhenStableUnderStabilitySearch) {
    Stepper s = start(
        "input a; output A, B; initial step 1; step 2 { A; } step 3 { B; }"
        "transition t1: 1 -> 2 when a; transition t2: 2 -> 3 when true;",
        searching);
    s.step({{"a", 1}});
    EXPECT_EQ(s["X_2"], 1);
    EXPECT_EQ(s["A"], 0) << "step 2 is transient: its output is never written";
    s.step({{"a", 1}});
    EXPECT_EQ(s["X_3"], 1);
    EXPECT_EQ(s["B"], 0);
    EXPECT_FALSE(s.settled()) << "stable, but B is not written";
    s.step({{"a", 1}});
    EXPECT_EQ(s["B"], 1);
    EXPECT_EQ(s["A"], 0);
    EXPECT_TRUE(s.settled());
}

TEST(ScheduleController, KeepsOutputsUnwrittenInStateZero) {
    EXPECT_EQ(power_on("output A; initial step 1 { A; }", cyclic)["A"], 0);
    EXPECT_EQ(power_on("input a; output A; initial step 1 { A if !a; }", cyclic)["A"], 0);
    EXPECT_EQ(power_on("output A; initial step 1 { A := true on activation; }", cyclic)["A"], 0);
}

TEST(ScheduleController, KeepsOutputsUnwrittenAfterTheFirstEvolutionUnderStabilitySearch) {
    Stepper s = start("output A; initial step 1 { A; }", searching);
    EXPECT_EQ(s["A"], 0);
    s.step();
    EXPECT_EQ(s["A"], 1);
}

TEST(ScheduleController, DefinesOutputsOverTheActivitiesWhenEveryCycleWrites) {
    Stepper s =
        start("input a; output A, B; initial step 1 { A; } step 2 { B; } transition t1: 1 -> 2 when a;", cyclic);
    EXPECT_EQ(s["A"], 1);
    s.step({{"a", 1}});
    EXPECT_EQ(s["A"], 0);
    EXPECT_EQ(s["B"], 1);
}

TEST(ScheduleController, SamplesTheInputsOfAnOutputInTheCycleThatWritesIt) {
    Stepper s = start("input a; output A; initial step 1 { A if a; }", cyclic, {{"a", 1}});
    EXPECT_EQ(s["A"], 1) << "the first evolution also writes outputs";
    s.set({{"a", 0}});
    EXPECT_EQ(s["A"], 1) << "the input changes; the output is unchanged until the next cycle";
    EXPECT_FALSE(s.settled());
    s.step();
    EXPECT_EQ(s["A"], 0);
    s.step({{"a", 1}});
    EXPECT_EQ(s["A"], 1);
}

TEST(ScheduleController, KeepsStoredOutputsInAnImageUntilTheyAreWritten) {
    Stepper s = start(
        "input a; output L, O; initial step 1; step 2 { L := true on activation; } step 3 { O; }"
        "transition t1: 1 -> 2 when a; transition t2: 2 -> 3 when true;",
        searching);
    s.step({{"a", 1}});
    EXPECT_EQ(s["L_image"], 1);
    EXPECT_EQ(s["L"], 0);
    s.step();
    EXPECT_EQ(s["L"], 0);
    s.step();
    EXPECT_EQ(s["L"], 1) << "written with the other outputs";
    EXPECT_EQ(s["O"], 1);
    EXPECT_FALSE(has_symbol(s.system, s.system.instances[{0}].name + ".O_image"));
}

TEST(ScheduleController, RunsTheActionsOfInitialStepsInTheFirstEvolution) {
    const char* text =
        "input level: int 0..3; internal n: int 0..5 = 1, m: int 0..5 = 2;"
        "initial step 1 { n := level + 1 on activation; }";
    EXPECT_EQ(power_on(text, searching)["n"], 1);
    const Stepper s = start(text, searching, {{"level", 3}});
    EXPECT_EQ(s["n"], 4);
    EXPECT_EQ(s["m"], 2);
    const Stepper t = start(text, searching, {{"level", 0}});
    EXPECT_EQ(t["n"], 1);
}

TEST(ScheduleController, ClearsNothingInTheFirstEvolutionAndIsNotQuiescentBeforeIt) {
    Stepper s = power_on(
        "input a; internal n = false; initial step 1 { n := true on activation; } step 2;"
        "transition t: 1 -> 2 when true;",
        searching);
    EXPECT_FALSE(s.settled());
    EXPECT_EQ(s["CF_t"], 0);
    s.step({{"a", 1}});
    EXPECT_EQ(s["X_1"], 1);
    EXPECT_EQ(s["n"], 1);
    EXPECT_EQ(s["CF_t"], 1);
}

TEST(ScheduleController, HasNoStepForAnUnobservableFirstEvolution) {
    const char* text = "input a; output A; initial step 1; step 2 { A; } transition t: 1 -> 2 when a;";
    for (const ExecutionMode mode : {searching, cyclic}) {
        Stepper s = power_on(text, mode);
        EXPECT_FALSE(s.system.controllers.front().starts.valid());
        s.step({{"a", 1}});
        EXPECT_EQ(s["X_2"], 1);
    }
}

TEST(ScheduleController, NoTimerExpiresBeforeTheFirstEvolution) {
    const Stepper s = power_on("output A; initial step 1 { A for 3s; }", cyclic);
    const TransitionSystem::Module& module = s.system.modules[s.system.instances[{0}].module];
    ASSERT_EQ(module.invariants.size(), 1U);
    Stepper early = s;
    early.set({{"T_X1_3s_Q", 1}});
    EXPECT_FALSE(is_allowed(early.system, early.state));
    EXPECT_TRUE(is_allowed(s.system, s.state));
}

TEST(ScheduleController, KeepsAValueThatWouldLeaveItsRangeAndRecordsTheFault) {
    Stepper s = start(
        "internal n: int 0..2 = 0; initial step 1; step 2 { n := n + 1 on activation; }"
        "transition t1: 1 -> 2 when true; transition t2: 2 -> 1 when true;",
        cyclic);
    for (const std::int64_t expected : {1, 1, 2, 2}) {
        s.step();
        EXPECT_EQ(s["n"], expected);
        EXPECT_EQ(s["out_of_range"], 0);
    }
    s.step();
    EXPECT_EQ(s["n"], 2) << "the value does not wrap around";
    EXPECT_EQ(s["out_of_range"], 1);
    s.step();
    EXPECT_EQ(s["out_of_range"], 1) << "the error persists";
    ASSERT_EQ(property_names(s.system), std::vector<std::string>{"no_out_of_range"});
    const Property& property = s.system.properties[{0}];
    EXPECT_EQ(property.pattern, Pattern::Never);
    EXPECT_NE(property.text.find(": n"), std::string::npos) << property.text;
    EXPECT_EQ(value_of(s.system, s.state, property.operands[0]), 1);
}

TEST(ScheduleController, WatchesNoRangeThatTypesKeep) {
    const Stepper s = start(
        "input level: int 0..3; internal n: int 0..4 = 0; initial step 1 { n := level % 3 + 1 on activation; }"
        "step 2 { n := 4 - level on activation; } transition t1: 1 -> 2 when level > 1;",
        cyclic);
    EXPECT_TRUE(s.system.properties.empty());
    EXPECT_FALSE(has_symbol(s.system, s.system.instances[{0}].name + ".out_of_range"));
}

TEST(ScheduleController, CountsADivisionByZeroAsAFault) {
    Stepper s = start("input d: int 0..2; initial step 1; step 2; transition t1: 1 -> 2 when 2 / d == 1;", cyclic);
    s.step({{"d", 0}});
    EXPECT_EQ(s["X_1"], 1) << "the condition has no value: the transition is not cleared";
    EXPECT_EQ(s["out_of_range"], 1);
    Stepper t = start("input d: int 0..2; initial step 1; step 2; transition t1: 1 -> 2 when 2 / d == 1;", cyclic);
    t.step({{"d", 2}});
    EXPECT_EQ(t["X_2"], 1);
    EXPECT_EQ(t["out_of_range"], 0);
    Stepper guarded =
        start("input d: int 0..2; initial step 1; step 2; transition t1: 1 -> 2 when d != 0 && 2 / d == 1;", cyclic);
    guarded.step({{"d", 0}});
    EXPECT_EQ(guarded["out_of_range"], 0) << "`and` stops at the first false operand";
}

TEST(ScheduleController, RecordsARace) {
    Stepper s = start(
        "input a; internal n: int 0..2 = 0; initial step 1; initial step 2;"
        "step 3 { n := 1 on activation; } step 4 { n := 2 on activation; }"
        "transition t1: 1 -> 3 when a; transition t2: 2 -> 4 when true;",
        cyclic);
    ASSERT_EQ(property_names(s.system), std::vector<std::string>{"no_race"});
    Stepper alone = s;
    alone.step();
    alone.step({{"a", 1}});
    EXPECT_EQ(alone["race"], 0);
    s.step({{"a", 1}});
    EXPECT_EQ(s["race"], 1);
    s.step();
    EXPECT_EQ(s["race"], 1) << "the error persists";
}

TEST(ScheduleController, KeepsInputsAndTimerOutputsFree) {
    const Stepper s = start("input a; initial step 1; step 2; transition t1: 1 -> 2 when 3s/X1 && a;", searching);
    const TransitionSystem::Module& main = s.system.modules[s.system.main];
    std::vector<std::string> free;
    for (const TransitionSystem::Symbol& symbol : main.symbols) {
        const auto* state = std::get_if<TransitionSystem::StateSymbol>(&symbol.kind);
        if (state != nullptr && !state->initial && !state->next) free.push_back(symbol.name);
    }
    EXPECT_EQ(free, (std::vector<std::string>{"a", "T_X1_3s_Q"}));
}

TEST(ScheduleController, TreatsAnUnwrittenInternalAsAConstant) {
    const Stepper s =
        start("internal armed = true; initial step 1; step 2; transition t1: 1 -> 2 when armed;", searching);
    EXPECT_EQ(s["armed"], 1);
    Stepper moved = s;
    moved.step();
    EXPECT_EQ(moved["X_2"], 1);
}

TEST(ScheduleController, GivesItsSymbolsNamesUnusedByTheChart) {
    const Stepper s =
        start("input stable, settled; output A; internal A_now = false; initial step 1 { A if stable; }", searching);
    EXPECT_TRUE(has_symbol(s.system, s.system.instances[{0}].name + ".stable_2"));
    EXPECT_TRUE(has_symbol(s.system, s.system.instances[{0}].name + ".A_now_2"));
}

TEST(ScheduleController, StatesTheImplicationsOfItsVerdicts) {
    const TransitionSystem search = schedule_controller(equations("initial step 1;"), searching);
    EXPECT_NE(search.scope.find("holds with every plant in grain atomic"), std::string::npos);
    EXPECT_NE(search.scope.find("written when the situation is stable"), std::string::npos);
    const TransitionSystem every = schedule_controller(equations("initial step 1;"), cyclic);
    EXPECT_NE(every.scope.find("written in every cycle"), std::string::npos);
}

TEST(Ranges, TermThatMayExceed64BitsIsUndefined) {
    Exprs exprs;
    const TypeOf few = [](const Expr&) { return integer_type(0, 3); };
    const Id<Expr> x = exprs.leaf(Op::Variable, 0);
    const auto is_more = [&](std::int64_t than) {
        return exprs.apply(Op::Greater, exprs.apply(Op::Plus, exprs.integer(than), x), x);
    };
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    EXPECT_TRUE(is_true(exprs, schedule::total(exprs, is_more(most - 2), few).undefined));
    EXPECT_TRUE(is_false(exprs, schedule::total(exprs, is_more(most - 4), few).undefined));
}

}  // namespace
}  // namespace grafverif
