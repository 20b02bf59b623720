// SPDX-License-Identifier: MIT
// Input abstraction on loops small enough to see what each level excludes.
#include "check/inputs/inputs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

#include "compose/observe.hpp"
#include "support/read_loop.hpp"
#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

/// The verdict that input abstractions give on the only property of a loop.
Verdict decided(const std::string& text, const InputLimits& limits = {}) {
    const Network loop = expand(read_loop(text).network);
    const Observe observe = [&](const Network& of) { return observed(of, watched(of)); };
    TimedOptions options{.max_states = 6, .timelock = false};
    TimedResult result = check_timed(observe(loop), options);
    result.time_passes = true;
    options.max_states = 100'000;
    decide_by_inputs(loop, observe, options, result, limits);
    const Verdict found = result.verdicts.front();
    if (found.run) {
        EXPECT_TRUE(replay(observe(loop), *found.run)) << "a run of the complete loop";
    }
    return found;
}

std::string loop(const std::string& ports, const std::string& body, const std::string& panel,
                 const std::string& property) {
    return "grafcet c {\n" + ports + "\n" + body + "}\nclosed_loop panel {\ncontroller c;\n" + panel +
           "\nproperty p: " + property + ";\n}\n";
}

TEST(InputAbstraction, ChoosesTheOutputsOfASelectorJointly) {
    const Verdict found = decided(
        loop("input S1, S2, A;", "initial step 0; step 1; transition t: 0 -> 1 when S1 && S2 && A;",
             "environment S = switch_2(FIRST = S1, SECOND = S2);\nenvironment B = free(OUT = A);", "reachable X1"));
    EXPECT_EQ(found.outcome, Outcome::Violated);
    ASSERT_TRUE(found.abstraction);
    EXPECT_EQ(found.abstraction->chosen, (std::vector<std::string>{"S", "B"}));
}

TEST(InputAbstraction, FollowsAViolationOnTheCompleteLoop) {
    const Verdict found =
        decided(loop("input A, B; output L;",
                     "initial step 0; step 1; step 2 { L; } transition t0: 0 -> 1 when A && !B; "
                     "transition t1: 1 -> 2 when B && !A;",
                     "environment EA = push_button(OUT = A);\nenvironment EB = push_button(OUT = B);", "never L"));
    EXPECT_EQ(found.outcome, Outcome::Violated);
    EXPECT_TRUE(found.run);
}

TEST(InputAbstraction, RefinesAButtonThatMustNotChangeTwiceInAnInstant) {
    const std::string text = loop("input A; output L;",
                                  "initial step 0; step 1 { L; } step 2; transition t0: 0 -> 1 when A; "
                                  "transition t1: 1 -> 2 when !A;",
                                  "environment EA = push_button(OUT = A, GAP = 2s);", "X1 holds for 2s");
    const Verdict found = decided(text);
    EXPECT_EQ(found.outcome, Outcome::Holds);
    ASSERT_TRUE(found.abstraction);
    EXPECT_TRUE(found.abstraction->chosen.empty());
}

TEST(InputAbstraction, LeavesTheVerdictOpenIfNoRoundIsLeft) {
    const std::string text = loop("input A; output L;",
                                  "initial step 0; step 1 { L; } step 2; transition t0: 0 -> 1 when A; "
                                  "transition t1: 1 -> 2 when !A;",
                                  "environment EA = push_button(OUT = A, GAP = 2s);", "X1 holds for 2s");
    const Verdict found = decided(text, {.rounds = 1});
    EXPECT_EQ(found.outcome, Outcome::Unknown);
    EXPECT_FALSE(found.abstraction);
}

TEST(InputAbstraction, IsOfferedForInstancesThatReadNothingButThemselves) {
    const Network network = expand(
        read_loop("grafcet c { input A, B, D; output Q; initial step 0 { Q; } step 1; transition t: 0 -> 1 when A && B "
                  "&& D; }\n"
                  "component lamp_of(input P) { initial location off; location on; urgent off -> on when P; timed on "
                  "-> off; }\n"
                  "component follower(input P; output S) { initial location off; location on; urgent off -> on when P "
                  "do S := true; "
                  "urgent on -> off when !P do S := false; }\n"
                  "closed_loop l { controller c; plant Fol = follower(P = Q, S = D); plant Lamp = lamp_of(P = B);\n"
                  "environment EA = push_button(OUT = A); environment EB = push_button(OUT = B); }\n")
            .network);
    const std::vector<AutonomousInstance> found = autonomous_instances(network);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(network.processes[found[0].process].name, "EA");
    EXPECT_FALSE(found[0].is_read);
    EXPECT_EQ(found[0].valuations, (std::vector<std::vector<std::int64_t>>{{0}, {1}}));
    EXPECT_EQ(network.processes[found[1].process].name, "EB");
    EXPECT_TRUE(found[1].is_read) << "by Lamp";
}

TEST(InputAbstraction, RejectsAnInstanceThatLeavesItsRange) {
    const Network network = expand(
        read_loop("grafcet c { input N: int 0..2; initial step 0; step 1; transition t: 0 -> 1 when N == 2; }\n"
                  "component counter(output V: int 0..2) { initial location any; timed any -> any do V := V + 1; }\n"
                  "closed_loop l { controller c; environment E = counter(V = N); }\n")
            .network);
    EXPECT_TRUE(autonomous_instances(network).empty());
}

/// Inputs I1..In, each of them free.
std::string free_inputs(int count, const std::function<std::string(const std::string&)>& term) {
    std::string names, panel, condition;
    for (int i = 1; i <= count; ++i) {
        const std::string name = "I" + std::to_string(i);
        names += (i == 1 ? "" : ", ") + name;
        panel += "environment E" + std::to_string(i) + " = free(OUT = " + name + ");\n";
        condition += (i == 1 ? "" : " || ") + term(name);
    }
    return loop("input " + names + "; output L;",
                "initial step 0; step 1 { L; } transition t0: 0 -> 1 when " + condition +
                    "; transition t1: 1 -> 0 when !(" + condition + ");",
                panel, "never X1 && X0");
}

TEST(InputAbstraction, DecidesAPanelOfTwoHundredInputs) {
    const Verdict found = decided(free_inputs(200, [](const std::string& name) { return name; }));
    EXPECT_EQ(found.outcome, Outcome::Holds);
    ASSERT_TRUE(found.abstraction);
    EXPECT_EQ(found.abstraction->chosen.size(), 200U);
}

TEST(InputAbstraction, LeavesOpenWhatASamplingCanChooseInTooManyWays) {
    const Verdict found = decided(free_inputs(20, [](const std::string& name) { return "rise(" + name + ")"; }),
                                  {.states = 20'000, .rounds = 2});
    EXPECT_EQ(found.outcome, Outcome::Unknown);
}

}  // namespace
}  // namespace grafverif
