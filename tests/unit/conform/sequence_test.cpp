// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "run/replay_test.hpp"
#include "syntax/print/automaton.hpp"
#include "syntax/print/test_csv.hpp"
#include "unit/conform/conforming.hpp"

namespace grafverif {
namespace {

std::string csv(const TestSequence& test) {
    std::ostringstream out;
    print_test_csv(out, test);
    return std::move(out).str();
}

TEST(MealyMachineOfTanks, HasTheCountsOfThePaper) {
    const MealyMachine with = machine(automaton(tanks(), search)), without = machine(automaton(tanks(), every_cycle));
    EXPECT_EQ(with.states.size(), 9U);
    EXPECT_EQ(transition_count(with), 288U);
    EXPECT_EQ(with.unstable_pairs, 9U);
    EXPECT_TRUE(with.activation.empty());
    EXPECT_EQ(without.states.size(), 10U);
    EXPECT_EQ(transition_count(without), 320U);
    EXPECT_EQ(without.unstable_pairs, 0U);
    EXPECT_EQ(without.activation.size(), 1U);
    EXPECT_EQ(transition_count(machine(automaton(tanks(full_is_not_empty)))), 9U * 18U);
}

TEST(TestSequenceOfTanks, IsProvenLeast) {
    struct Case {
        ExecutionMode mode;
        bool one_cycle_each;
        std::size_t steps, covered;
    };
    for (const Case& one : {Case{search, false, 278, 279},
                            {search, true, 348, 279},
                            {every_cycle, false, 436, 320},
                            {every_cycle, true, 510, 320}}) {
        SCOPED_TRACE(one.steps);
        const TestSequence test =
            test_of(machine(automaton(tanks(), one.mode)), TestCover::Transitions, one.one_cycle_each);
        EXPECT_EQ(step_count(test), one.steps);
        EXPECT_EQ(test.lower_bound, one.steps);
        EXPECT_TRUE(test.proven_least);
        EXPECT_EQ(test.sequences.size(), 1U);
        EXPECT_EQ(test.covered, one.covered);
        EXPECT_EQ(disagreement(chart(tanks()), test), std::nullopt);
    }
}

TEST(TestSequenceOfTanks, AppliesNoInputsThatAConstraintExcludes) {
    for (const bool one_cycle_each : {false, true})
        for (const TestCover cover : {TestCover::Transitions, TestCover::Evolutions, TestCover::Locations}) {
            const TestSequence test = test_of(machine(automaton(tanks(full_is_not_empty))), cover, one_cycle_each);
            EXPECT_EQ(disagreement(chart(tanks(full_is_not_empty)), test), std::nullopt);
            if (cover == TestCover::Transitions) {
                EXPECT_EQ(test.covered, 9U * 18U);
            }
            for (const TestSequence::Step& step : test.sequences.at(0).steps) {
                EXPECT_TRUE(step.inputs[1] == 0 || step.inputs[3] == 1);
                EXPECT_TRUE(step.inputs[2] == 0 || step.inputs[4] == 1);
            }
        }
}

/// Returns the number of pairs of a state and inputs that the steps of `test` cover, according to the conditions of the
/// machine.
std::size_t crossed(const MealyMachine& machine, const TestSequence& test) {
    std::set<std::pair<std::uint32_t, std::vector<std::int64_t>>> pairs;
    for (const TestSequence::Sequence& sequence : test.sequences) {
        Id<MealyMachine::State> state = machine.initial;
        for (const TestSequence::Step& step : sequence.steps)
            for (std::uint32_t cycle = 0; cycle < step.cycles; ++cycle) {
                pairs.emplace(state.index, step.inputs);
                for (const MealyMachine::Transition& one : transitions_from(machine, state))
                    if (evaluate(machine.exprs, one.condition, [&](const Expr& leaf) {
                            return step.inputs[static_cast<std::size_t>(leaf.value)];
                        }) == 1) {
                        EXPECT_EQ(machine.answers[one.answer].values, step.outputs);
                        state = one.to;
                        break;
                    }
            }
    }
    return pairs.size();
}

TEST(TestSequenceOfTanks, CrossesEveryTransition) {
    for (const ExecutionMode mode : {search, every_cycle})
        for (const bool one_cycle_each : {false, true}) {
            const MealyMachine found = machine(automaton(tanks(), mode));
            const TestSequence test = test_of(found, TestCover::Transitions, one_cycle_each);
            EXPECT_EQ(crossed(found, test), test.to_cover);
        }
}

TEST(TestSequenceOfTanks, CoversLessOnRequestForLess) {
    const MealyMachine found = machine(automaton(tanks()));
    const TestSequence evolutions = test_of(found, TestCover::Evolutions),
                       locations = test_of(found, TestCover::Locations);
    EXPECT_EQ(evolutions.to_cover, 54U);
    EXPECT_TRUE(evolutions.proven_least);
    EXPECT_LT(step_count(evolutions), 100U);
    EXPECT_EQ(locations.to_cover, 9U);
    EXPECT_LE(step_count(locations), 12U);
    std::set<std::uint32_t> seen;
    for (const TestSequence::Step& step : locations.sequences.at(0).steps) seen.insert(step.situation.index);
    EXPECT_EQ(seen.size(), 9U);
}

TEST(TestSequence, StartsWithTheScanThatActivatesTheInitialSteps) {
    const TestSequence test = test_of(machine(
        automaton("input a; output O; initial step 1; step 2 { O; } transition t0: 1 -> 2 when a;", every_cycle)));
    EXPECT_EQ(csv(test),
              "sequence,step,wait,cycles,a,O,situation\n"
              "1,0,,1,0,0,{1}\n"
              "1,1,,2,0,0,{1}\n"
              "1,2,,2,1,1,{2}\n"
              "1,3,,2,0,1,{2}\n");
}

TEST(TestSequence, OfAMachineWithoutPathBackRestartsFromPowerOn) {
    const std::string text =
        "input a, b; output O, P; initial step 1; step 2 { O; } step 3 { P; }"
        "transition t0: 1 -> 2 when a && !b; transition t1: 1 -> 3 when b;";
    const TestSequence test = test_of(machine(automaton(text)));
    EXPECT_EQ(test.sequences.size(), 3U);  // `a and not b`, `not a and b`, and `a and b` leave {1}
    const std::string words = summary(test),
                      traps = words.substr(std::min(words.size(), words.find("; no transition")));
    EXPECT_TRUE(traps == "; no transition leads back from {2} and {3}" ||
                traps == "; no transition leads back from {3} and {2}")
        << words;
    EXPECT_EQ(step_count(test), 9U);  // 3 of the 12 pairs are covered on arrival
    EXPECT_TRUE(test.proven_least);
    EXPECT_EQ(disagreement(chart(text), test), std::nullopt);
}

TEST(TestSequence, WaitsForTimersWithTheInputsHeld) {
    const std::string text =
        "input a; output O; initial step 1; step 2 { O; }"
        "transition t0: 1 -> 2 when a; transition t1: 2 -> 1 when 3s/X2 && !a;";
    const MealyMachine found = machine(automaton(text));
    ASSERT_EQ(found.states.size(), 3U);  // the states are {1}, {2} before the timer expires, and {2} after that
    const TestSequence test = test_of(found);
    EXPECT_EQ(disagreement(chart(text), test), std::nullopt);
    bool waits = false;
    for (const TestSequence::Sequence& sequence : test.sequences)
        for (const TestSequence::Step& step : sequence.steps) waits = waits || step.wait_ms == 3000;
    EXPECT_TRUE(waits);
}

TEST(TestSequence, WaitsForEveryKindOfTimer) {
    for (const char* text :
         {"input a; output O; initial step 1 { O if 3s/a/2s; }", "input a; output O; initial step 1 { O if a/2s; }",
          "input a; output O; initial step 1 { O if 3s/a; }",
          "input a, b; output O, P; initial step 1; step 2 { O after 2s; P for 3s; }"
          "transition t0: 1 -> 2 when a; transition t1: 2 -> 1 when b/1s && !a;"})
        for (const ExecutionMode mode : {search, every_cycle}) {
            SCOPED_TRACE(text);
            const TestSequence test = test_of(machine(automaton(text, mode)));
            EXPECT_EQ(disagreement(chart(text), test), std::nullopt);
            std::int64_t waited = 0;
            for (const TestSequence::Sequence& sequence : test.sequences)
                for (const TestSequence::Step& step : sequence.steps) waited += step.wait_ms;
            EXPECT_GT(waited, 0);
        }
}

TEST(TestSequence, OfAFallTimeSeesItRunAndEnd) {
    EXPECT_EQ(csv(test_of(machine(automaton("input a; output O; initial step 1 { O if a/2s; }")))),
              "sequence,step,wait,cycles,a,O,situation\n"
              "1,1,,2,1,1,{1}\n"
              "1,2,,2,0,1,{1}\n"
              "1,3,,2,1,1,{1}\n"
              "1,4,2s,2,1,1,{1}\n"  // a stays true beyond the fall time that began in step 2
              "1,5,,2,0,1,{1}\n"
              "1,6,,2,1,1,{1}\n"
              "1,7,,2,0,1,{1}\n"
              "1,8,2s,2,0,0,{1}\n");
}

TEST(TestSequence, SuggestsALowerCoverageForTooManyInputs) {
    std::string text = "input i0";
    for (int k = 1; k < 40; ++k) text += ", i" + std::to_string(k);
    text +=
        "; output O; initial step 1; step 2 { O; } transition t0: 1 -> 2 when i0 && i39; transition t1: 2 -> 1 when "
        "!i7;";
    const MealyMachine found = machine(automaton(text));
    EXPECT_EQ(found.combinations, std::uint64_t{1} << 40U);
    Diagnostics diagnostics;
    EXPECT_FALSE(test_sequence(found, {}, {}, diagnostics));
    EXPECT_EQ(diagnostics.all().at(0).code, "too-many-inputs");
    EXPECT_EQ(step_count(test_of(found, TestCover::Evolutions)), 2U);
}

TEST(MealyMachine, IsMinimizedByItsOutputs) {
    const MealyMachine found =
        machine(automaton("input a; output O; initial step 1; step 2 { O; } step 3; step 4 { O; }"
                          "transition t0: 1 -> 2 when a; transition t1: 2 -> 3 when !a;"
                          "transition t2: 3 -> 4 when a; transition t3: 4 -> 1 when !a;"));
    EXPECT_EQ(found.states.size(), 4U);
    const MealyMachine smallest = least(found);
    ASSERT_EQ(smallest.states.size(), 1U);  // the value of O is the value of a
    EXPECT_EQ(smallest.states[smallest.initial].situation, "{1} or {2} or {3} or {4}");
    EXPECT_EQ(least(machine(automaton(tanks()))).states.size(), 9U);
}

TEST(MealyMachine, IsMinimisedWithinItsBounds) {
    const MealyMachine found = machine(automaton(tanks()));
    const std::atomic<bool> stop{true};
    for (const auto& [bounds, code] : {std::pair(MealyOptions{.deadline = std::chrono::steady_clock::now()}, "stopped"),
                                       {MealyOptions{.stop = &stop}, "stopped"},
                                       {MealyOptions{.max_memory = 1}, "bound-reached"}}) {
        Diagnostics diagnostics;
        EXPECT_EQ(minimised(found, bounds, {}, diagnostics), std::nullopt);
        EXPECT_EQ(diagnostics.all().at(0).code, code);
    }
}

TEST(TestSequence, OfAMinimizedMachineHoldsInputsOnlyIfTheOutputIsUnchanged) {
    // In the next cycle, {1} and {1,2} have the same outputs. Therefore both situations are merged
    // into one state, which can be entered with different outputs.
    const std::string text =
        "input a; output O, P; initial step 2 { O; } initial step 1 { P; } transition t0: 2 -> 1 when true;"
        "step 3; transition t1: 3 -> when fall(a);";
    const TestSequence test = test_of(least(machine(automaton(text, every_cycle))));
    EXPECT_EQ(disagreement(chart(text), test), std::nullopt);
}

TEST(TestSequence, ExpectsNoOutputWhoseInputsAConstraintExcludes) {
    const std::string text =
        "input a, b; output O, P; constraint !a || !b; initial step 1 { O if a && b; P if !a || !b; }";
    const LocationAutomaton found = automaton(text);
    for (const LocationAutomaton::Location& location : found.locations) EXPECT_LE(location.emissions.size(), 1U);
    const TestSequence test = test_of(machine(found));
    EXPECT_EQ(test.covered, 3U);
    EXPECT_EQ(disagreement(chart(text), test), std::nullopt);
}

TEST(TestSequence, WithWrongExpectedOutputFailsOnTheInterpreter) {
    TestSequence test = test_of(machine(automaton(tanks())));
    test.sequences[0].steps[17].outputs[1] ^= 1;
    const auto wrong = disagreement(chart(tanks()), test);
    ASSERT_TRUE(wrong);
    EXPECT_TRUE(wrong->starts_with("sequence 1, step 18: `V2` is ")) << *wrong;
}

}  // namespace
}  // namespace grafverif
