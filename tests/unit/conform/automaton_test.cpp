// SPDX-License-Identifier: MIT
#include <algorithm>
#include <sstream>

#include "unit/conform/conforming.hpp"

namespace grafverif {
namespace {

std::string printed(const LocationAutomaton& automaton) {
    std::ostringstream out;
    print_automaton(out, automaton, true);
    std::string text = std::move(out).str();
    return text.substr(text.find("\n\n") + 2);
}

TEST(LocationAutomatonOfTanks, HasTheCountsOfThePaper) {
    const AutomatonCounts with = counts(automaton(tanks(), search)), without = counts(automaton(tanks(), every_cycle));
    EXPECT_EQ(with.locations, 10U);
    EXPECT_EQ(with.evolutions - with.evolutions_from_init, 54U);
    EXPECT_EQ(with.evolutions, 62U);
    EXPECT_EQ(with.unstable, 9U);
    EXPECT_EQ(without.locations, 11U);
    EXPECT_EQ(without.evolutions, 19U);
    EXPECT_EQ(without.evolutions_from_init, 1U);
    EXPECT_EQ(without.unstable, 0U);
    const AutomatonCounts assumed = counts(automaton(tanks(full_is_not_empty), search));
    EXPECT_EQ(assumed.locations, 10U);
    EXPECT_EQ(assumed.evolutions - assumed.evolutions_from_init, 25U);
    EXPECT_EQ(assumed.evolutions, 29U);
    EXPECT_EQ(assumed.unstable, 0U);
}

TEST(LocationAutomaton, LimitedAutomatonHasLowerBoundsOfTheCounts) {
    for (const ExecutionMode mode : {search, every_cycle}) {
        const LocationAutomaton all = automaton(tanks(), mode);
        for (std::uint64_t limit = 1; limit <= all.locations.size(); ++limit) {
            Diagnostics diagnostics;
            AutomatonOptions options;
            options.mode = mode;
            options.max_locations = limit;
            options.partial = true;
            const auto part = location_automaton(equations(tanks()), options, diagnostics);
            ASSERT_TRUE(part.has_value());
            EXPECT_EQ(verify(*part), std::vector<std::string>{});
            EXPECT_EQ(part->complete, limit >= all.locations.size());
            EXPECT_LE(part->looked_at, part->locations.size());
            EXPECT_LE(part->locations.size(), all.locations.size());
            EXPECT_LE(part->evolutions.size(), all.evolutions.size());
            for (const auto& location : part->locations)
                EXPECT_NE(std::ranges::find(all.locations, location), all.locations.end());
            std::ostringstream out;
            print_automaton(out, *part, false);
            EXPECT_EQ(out.str().find("at least") != std::string::npos, !part->complete) << out.str();
        }
    }
}

TEST(LocationAutomaton, ReportsTheCycleOfATotalInstability) {
    const LocationAutomaton found = automaton(tanks());
    ASSERT_EQ(found.instabilities.size(), 10U);
    for (const LocationAutomaton::Instability& instability : found.instabilities) {
        EXPECT_EQ(condition_text(found, instability.condition), "s and h1 and h2 and not l1 and not l2");
        EXPECT_EQ(instability.witness, (std::vector<std::int64_t>{1, 1, 1, 0, 0}));
        ASSERT_EQ(instability.cycle.size(), 4U);
        EXPECT_EQ(situation_text(found, instability.cycle[0]), "{1}");
        EXPECT_EQ(situation_text(found, instability.cycle[3]), "{4,7}");
    }
}

TEST(LocationAutomaton, ClearsAllThatCanBeClearedTogether) {
    EXPECT_EQ(printed(automaton("input a, b; output O; initial step 1 { O; } initial step 2; step 3; step 4;"
                                "transition t0: 1 -> 3 when a; transition t1: 2 -> 4 when a && b;",
                                every_cycle)),
              "0  INIT {1,2}\n"
              "    -> 1 {1,2}  when true\n"
              "\n"
              "1  {1,2}  / O\n"
              "    -> 2 {2,3}  when a and not b\n"
              "    -> 3 {3,4}  when a and b\n"
              "\n"
              "2  {2,3}\n"
              "    -> 3 {3,4}  when a and b\n"
              "\n"
              "3  {3,4}\n");
}

TEST(LocationAutomaton, KeepsStoredVariablesInItsLocations) {
    EXPECT_EQ(
        printed(automaton("input a; output L; internal N: int 0..1 = 0; initial step 1 { N := 1 - N on deactivation; }"
                          "step 2 { L := N == 1 on activation; }"
                          "transition t0: 1 -> 2 when a; transition t1: 2 -> 1 when !a;")),
        "0  INIT {1}  L = 0  N = 0\n"
        "    -> 2 {2}  when a\n"
        "\n"
        "1  {1}  L = 0  N = 0\n"
        "    -> 2 {2}  when a\n"
        "\n"
        "2  {2}  L = 0  N = 1\n"  // L stores the old value of N
        "    -> 3 {1}  when not a\n"
        "\n"
        "3  {1}  L = 0  N = 1\n"
        "    -> 4 {2}  when a\n"
        "\n"
        "4  {2}  L = 1  N = 0  / L\n"
        "    -> 5 {1}  when not a\n"
        "\n"
        "5  {1}  L = 1  N = 0  / L\n"
        "    -> 2 {2}  when a\n");
}

TEST(LocationAutomaton, ReadsIntegerInputsByTheirValues) {
    EXPECT_EQ(printed(automaton(
                  "input level: int 0..5; output O; initial step 1; step 2 { O if level > 3; }"
                  "transition t0: 1 -> 2 when level >= 2 && level <= 4; transition t1: 2 -> 1 when level == 0;")),
              "0  INIT {1}\n"
              "    -> 2 {2}  when level >= 2 and level <= 4\n"
              "\n"
              "1  {1}\n"
              "    -> 2 {2}  when level >= 2 and level <= 4\n"
              "\n"
              "2  {2}  / O if level >= 4\n"
              "    -> 1 {1}  when level == 0\n");
}

TEST(LocationAutomaton, ATimerIsAnInputThatIsFalseInANewlyActiveStep) {
    const LocationAutomaton found = automaton(
        "input a; output O; initial step 1; step 2 { O; } step 3;"
        "transition t0: 1 -> 2 when a; transition t1: 2 -> 3 when 3s/X2 || !a; transition t2: 3 -> 2 when a;");
    EXPECT_EQ(printed(found),
              "0  INIT {1}\n"
              "    -> 2 {2}  when a; starts 3s/X2\n"
              "\n"
              "1  {1}\n"
              "    -> 2 {2}  when a; starts 3s/X2\n"
              "\n"
              "2  {2}  / O\n"
              "    -> 3 {3}  when not a\n"
              "    -> 2 {2}  when a and 3s/X2; starts 3s/X2\n"
              "\n"
              "3  {3}\n"
              "    -> 2 {2}  when a; starts 3s/X2\n");
}

TEST(LocationAutomaton, DelayedAndLimitedActionsAreOutputsThatReadTimers) {
    EXPECT_EQ(printed(automaton("input a; output O, P; initial step 1; step 2 { O after 2s; P for 5s; }"
                                "transition t0: 1 -> 2 when a; transition t1: 2 -> 1 when !a;")),
              "0  INIT {1}\n"
              "    -> 2 {2}  when a; starts 2s/X2; starts 5s/X2\n"
              "\n"
              "1  {1}\n"
              "    -> 2 {2}  when a; starts 2s/X2; starts 5s/X2\n"
              "\n"
              "2  {2}  / O if 2s/X2, P if not 5s/X2\n"
              "    -> 1 {1}  when not a\n");
}

TEST(LocationAutomaton, TheLevelThatATimerWatchesIsPartOfTheLocation) {
    EXPECT_EQ(printed(automaton("input a; output O; initial step 1; step 2 { O; } transition t0: 1 -> 2 when a/2s; "
                                "transition t1: 2 -> 1 when !a;",
                                every_cycle)),
              "0  INIT {1}  V_a = 0\n"
              "    -> 1 {1}  when not a and not a/2s\n"
              "    -> 2 {1}  when a and not a/2s; starts a/2s\n"
              "\n"
              "1  {1}  V_a = 0\n"
              "    -> 3 {2}  when not a and a/2s\n"
              "    -> 4 {2}  when a; starts a/2s\n"
              "\n"
              "2  {1}  V_a = 1\n"
              "    -> 3 {2}  when not a; ends a/2s\n"
              "    -> 4 {2}  when a\n"
              "\n"
              "3  {2}  V_a = 0  / O\n"
              "    -> 4 {2}  when a; starts a/2s\n"
              "    -> 1 {1}  when not a\n"
              "\n"
              "4  {2}  V_a = 1  / O\n"
              "    -> 1 {1}  when not a; ends a/2s\n");
}

TEST(LocationAutomaton, TimersOfOneStepExpireInOrderOfDuration) {
    const LocationAutomaton found = automaton(
        "input a, b; output O; initial step 1; step 2 { O; } step 3; step 4;"
        "transition t0: 1 -> 2 when a; transition t1: 2 -> 3 when 3s/X2 && !b; transition t2: 2 -> 4 when 5s/X2 && "
        "3s/X2;"
        "transition t3: 3 -> 1 when !a; transition t4: 4 -> 1 when !a;");
    bool seen = false;  // true for a condition that contains 5s/X2 without 3s/X2, which 5s/X2 implies
    for (const LocationAutomaton::Evolution& evolution : found.evolutions)
        seen = seen || condition_text(found, evolution.condition) == "a and b and 5s/X2";
    EXPECT_TRUE(seen) << printed(found);
    const MealyMachine timed = machine(found);
    std::vector<std::int64_t> waits;
    for (const MealyMachine::Transition& transition : timed.transitions)
        if (transition.wait_ms != 0) waits.push_back(transition.wait_ms);
    std::ranges::sort(waits);
    const auto repeated = std::ranges::unique(waits);
    waits.erase(repeated.begin(), repeated.end());
    EXPECT_EQ(waits, (std::vector<std::int64_t>{2000, 3000}));
}

TEST(LocationAutomaton, RejectsChartsThatCannotBeTested) {
    EXPECT_EQ(refusal("output O; initial step 1 { O; }"),
              "[nothing-to-test] `chart` has no inputs and cannot be tested; declare at least one");
    EXPECT_EQ(refusal("input a; initial step 1; step 2; transition t0: 1 -> 2 when a;"),
              "[nothing-to-test] `chart` has no outputs and cannot be tested; declare at least one");
    EXPECT_EQ(
        refusal("input a; output O; constraint a; constraint !a; initial step 1 { O; }"),
        "[excludes-every-input] no combination of inputs satisfies this constraint and the constraints before it; "
        "weaken one of these constraints");
    EXPECT_EQ(
        refusal("input a; output O; initial step 1 { O; } step 2; transition t0: 1 -> 2 when true; transition "
                "t1: 2 -> 1 when true;"),
        "[never-stable] no combination of inputs leads from the initial situation to a stable one: with not a, the "
        "chart cycles forever through the situations {1} -> {2} -> {1}; add a condition that breaks the cycle");
}

TEST(LocationAutomaton, StopsAtRacesAndValuesThatDoNotFit) {
    EXPECT_EQ(refusal("input a, b; output L; initial step 1; step 2 { L := true on activation; } initial step 3; step "
                      "4 { L := false on "
                      "activation; } transition t0: 1 -> 2 when a; transition t1: 3 -> 4 when b;"),
              "[action-race] two actions store different values in `L` in the same evolution, in {1,3} with a, b; make "
              "their conditions exclusive, or exclude these inputs with a `constraint`");
    EXPECT_EQ(
        refusal("input a; output O; internal N: int 0..1 = 0; initial step 1; step 2 { O; N := N + 1 on activation; }"
                "transition t0: 1 -> 2 when a; transition t1: 2 -> 1 when !a;"),
        "[out-of-range] `N` is assigned 2, which is outside its range, in {1} with a; extend the range or guard the "
        "assignment");
    EXPECT_EQ(refusal("input level: int 0..2; output O; initial step 1; step 2 { O; } transition t0: 1 -> 2 when 2 / "
                      "level == 1;"),
              "[no-value] the value is undefined in {1} with level = 0: division by zero or overflow; guard the "
              "operation with a condition");
    EXPECT_EQ(refusal("input level: int 0..2; output O; constraint level > 0; initial step 1; step 2 { O; }"
                      "transition t0: 1 -> 2 when 2 / level == 1;"),
              "no error");
}

TEST(LocationAutomaton, OfTwoValuesStoredAtOnceBothMustExist) {
    EXPECT_EQ(refusal("input a; output O; internal N: int 0..3 = 0; internal M: int 0..3 = 0;"
                      "initial step 1 { O; N := 0 on activation; N := 1 % M on activation; }"),
              "[no-value] the value is undefined in {1} with not a: division by zero or overflow; guard the operation "
              "with a condition");
    EXPECT_EQ(refusal("input a; output O; internal N: int 0..3 = 0; internal M: int 0..3 = 0;"
                      "initial step 1; step 2 { O; N := 0 on activation; N := 1 % M on activation; } transition t0: 1 "
                      "-> 2 when a;"),
              "[no-value] the value is undefined in {1} with a: division by zero or overflow; guard the operation with "
              "a condition");
}

TEST(LocationAutomaton, EndsAtItsLimits) {
    AutomatonOptions options;
    options.max_locations = 5;
    EXPECT_EQ(refusal(tanks(), options),
              "[bound-reached] the location automaton has more than 5 locations; raise `--max-states`");
}

TEST(LocationAutomaton, ForgetsNoInstabilityThatStartsLate) {
    // {1} is stable if a is false. With a and b, the chart cycles 1 -> 2 -> 3 -> 2 -> ... forever.
    const LocationAutomaton found = automaton(
        "input a, b; output O; initial step 1; step 2 { O; } step 3;"
        "transition t0: 1 -> 2 when a; transition t1: 2 -> 3 when a && b; transition t2: 3 -> 2 when b;");
    ASSERT_FALSE(found.instabilities.empty());
    for (const LocationAutomaton::Instability& instability : found.instabilities) {
        ASSERT_EQ(instability.cycle.size(), 2U);
        EXPECT_EQ(condition_text(found, instability.condition), "a and b");
        EXPECT_EQ(instability.combinations, 1U);
    }
}

}  // namespace
}  // namespace grafverif
