// SPDX-License-Identifier: MIT
// Tests input abstraction on loops that are small enough to show which runs each level excludes.
#include "check/inputs/inputs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "check/inputs/alternatives.hpp"
#include "check/inputs/impossible.hpp"
#include "compose/observe.hpp"
#include "pipeline/staged_search.hpp"
#include "support/read_loop.hpp"
#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

/// Returns the result of a first search that leaves the properties of `observed` undecided.
TimedResult undecided(const Network& observed) {
    TimedResult result = check_timed(observed, {.max_states = 6, .timelock = false});
    result.time_passes = true;
    return result;
}

/// Returns a station of the folder `bench/stations` with only one of its properties.
Network station_with(const std::string& file, const std::string& property) {
    Network loop = expand(read_sample("../bench/stations/" + file).network);
    for (const Property& each : std::exchange(loop.properties, {}))
        if (each.name == property) loop.properties.add(each);
    return loop;
}

/// Returns the verdict of input abstraction on the only property of a loop. With the default limits, the complete loop
/// is not searched first.
Verdict decided(const std::string& text, const InputLimits& limits = {.explored = 0},
                const InputAblations& ablations = {}, Grain grain = Grain::Phased) {
    const Network loop = expand(read_loop(text, {.grain = grain}).network);
    const Observe observe = [&](const Network& of) { return observed(of, watched(of)); };
    const TimedOptions options{.max_states = 100'000, .timelock = false};
    TimedResult result = undecided(observe(loop));
    InputSearch search(loop, observe, options, result, limits, ablations);
    for (const std::uint64_t states : {8U, 64U, 100'000U})
        if (!search.run(states, {})) break;
    const Verdict found = result.verdicts.front();
    if (found.run) {
        EXPECT_TRUE(replay(observe(loop), *found.run)) << "a run of the complete loop";
    }
    return found;
}

TEST(InputAbstraction, DeclaredPropertiesWithNamesOfImplicitOnesAreProvedThemselves) {
    const auto loop = read_loop(
        "grafcet c { input A; output L; internal M; initial step 0 { M := true on activation; }\n"
        "step 1 { L; M := false on activation; }\n"
        "transition t0: 0 -> 1 when A; transition t1: 1 -> 0 when !A; }\n"
        "closed_loop l { controller c; environment E = push_button(OUT = A);\n"
        "property fine: never X0 && X1; property no_race: never X1; }\n");
    const StateProver prove = prover_by_pdr(translator_of_abstractions(loop.model, {0}));
    const std::uint64_t memory = std::uint64_t{1} << 30U;
    const auto outcome = [&](const Network& network, const std::string& property) {
        return prove({network, property, {}, {}, memory}).outcome;
    };
    // A network with only one property, as for a property with an observer: its implicit property is named `no_race`.
    Network alone = expand(loop.network);
    for (const Property& property : std::exchange(alone.properties, {}))
        if (property.name == "fine") alone.properties.add(property);
    EXPECT_EQ(outcome(alone, "fine"), Outcome::Holds);
    EXPECT_EQ(outcome(expand(loop.network), "no_race"), Outcome::Violated);
}

/// Before the first evolution, the instances EA and EB move; the first evolution reads their
/// outputs A and B.
TEST(InputAbstraction, MacroStepsKeepMovesBeforeTheFirstEvolution) {
    const Network loop = expand(
        read_loop(
            "grafcet c { input A, B, C; output L; internal M = false; initial step 0 { M := A && B on activation; }\n"
            "step 1 { L; } transition t0: 0 -> 1 when C; }\n"
            "closed_loop l { controller c; environment EA = free(OUT = A); environment EB = free(OUT = B);\n"
            "environment EC = push_button(OUT = C); property p: never M && X1; }\n")
            .network);
    const std::vector<AbstractableProcess> processes = abstractable_processes(loop);
    std::vector<InputLevel> levels;
    for (const AbstractableProcess& process : processes)
        levels.push_back(loop.processes[process.process].name == "EC" ? InputLevel::Chosen : InputLevel::Untimed);
    const InputAbstraction abstraction = abstract_inputs(loop, processes, levels);
    ASSERT_FALSE(abstraction.unprompted.empty());
    const TimedResult found = check_timed(
        abstraction.network,
        {.timelock = false,
         .choices = abstraction.choices,
         .macro_steps = {.enabled = true, .deferred = abstraction.deferred, .unprompted = abstraction.unprompted}});
    EXPECT_EQ(found.verdicts.front().outcome, Outcome::Violated);
}

TEST(InputAbstraction, MacroStepsMakeTheCoarseSearchOfAStationSmall) {
    Network loop = expand(read_sample("../bench/stations/undecided/capper.grafcet").network);
    for (const Property& property : std::exchange(loop.properties, {}))
        if (property.name == "one_mode") loop.properties.add(property);
    const std::vector<AbstractableProcess> processes = abstractable_processes(loop);
    std::vector<InputLevel> levels;
    for (const AbstractableProcess& process : processes)
        levels.push_back(process.valuations.empty() ? InputLevel::Untimed : InputLevel::Chosen);
    const InputAbstraction abstraction = abstract_inputs(loop, processes, levels);
    TimedOptions options{.max_states = 50'000, .timelock = false, .choices = abstraction.choices};
    EXPECT_FALSE(check_timed(abstraction.network, options).complete);
    options.macro_steps = {.enabled = true, .deferred = abstraction.deferred, .unprompted = abstraction.unprompted};
    const TimedResult found = check_timed(abstraction.network, options);
    EXPECT_EQ(found.verdicts.front().outcome, Outcome::Holds);
    EXPECT_LT(found.states, 1500U);
}

/// The operator presses START and turns the key in the same cycle.
TEST(InputAbstraction, FollowsTheViolationOfAStationInTheFirstRound) {
    const Network loop = station_with("undecided/capper.grafcet", "belt_free");
    const Observe observe = [](const Network& of) { return of; };
    const TimedOptions options{.max_states = 100'000, .timelock = false};
    TimedResult result = undecided(loop);
    InputSearch search(loop, observe, options, result, {.followed_coarse = 10'000, .explored = 0});
    search.run(4096, {});
    EXPECT_EQ(result.verdicts.front().outcome, Outcome::Violated);
    ASSERT_TRUE(result.verdicts.front().run);
    EXPECT_TRUE(replay(loop, *result.verdicts.front().run));
}

Alternatives::Levels at_level(InputLevel level) { return {level}; }

TEST(InputAbstraction, CheapAlternativesComeFirst) {
    Alternatives alternatives;
    alternatives.exclude(at_level(InputLevel::Chosen));
    alternatives.add({at_level(InputLevel::Chosen), true, 0});
    EXPECT_FALSE(alternatives.has_any());
    alternatives.add({at_level(InputLevel::Untimed), true, 3});
    alternatives.add({at_level(InputLevel::Paced), true, 1});
    alternatives.add({at_level(InputLevel::Paced), true, 0});  // known levels: no effect
    alternatives.postpone({at_level(InputLevel::Complete), true, 0});
    EXPECT_EQ(alternatives.take(), (Alternatives::Alternative{at_level(InputLevel::Paced), true, 1}));
    EXPECT_EQ(alternatives.take(), (Alternatives::Alternative{at_level(InputLevel::Untimed), true, 3}));
    EXPECT_FALSE(alternatives.has_for_round());
    EXPECT_TRUE(alternatives.has_any());
    alternatives.begin_round();
    EXPECT_EQ(alternatives.take().levels, at_level(InputLevel::Complete));
    EXPECT_FALSE(alternatives.has_any());
}

/// The preferred refinement first raises the guard door, although the proof needs only the rivet cylinder and the
/// emergency stop.
TEST(InputAbstraction, AlternativeProvesAPropertyOfAStation) {
    const Network loop = station_with("independent/riveting.grafcet", "retracts");
    const Observe observe = [](const Network& of) { return observed(of, watched(of)); };
    const auto verdict = [&](std::size_t alternatives) {
        const TimedOptions options{.max_states = 100'000, .timelock = false};
        TimedResult result = undecided(observe(loop));
        InputSearch search(loop, observe, options, result,
                           {.alternatives = alternatives, .first_share = 1e9, .explored = 0});
        for (const std::uint64_t states : {search_rounds[0], search_rounds[1]}) search.run(states, {});
        return result.verdicts.front();
    };
    EXPECT_EQ(verdict(0).outcome, Outcome::Unknown);
    const Verdict proved = verdict(32);
    EXPECT_EQ(proved.outcome, Outcome::Holds);
    ASSERT_TRUE(proved.abstraction);
    EXPECT_EQ(std::ranges::count(proved.abstraction->paced, "E_Stop"), 0);
    EXPECT_EQ(std::ranges::count(proved.abstraction->chosen, "Guard"), 1);
}

/// The search rounds the minimum time between two changes of the button, 300 ms, to one unit of 2 s, the duration of
/// the stroke of the cylinder. Each run with the longer unit is a run of the loop.
TEST(InputAbstraction, RunsInALongerTimeUnitAreRunsOfTheLoop) {
    const Network loop = expand(
        read_loop("grafcet c { input A, AT_BACK, AT_FRONT; output G_OUT; initial step 0; step 1 { G_OUT; } step 2;\n"
                  "transition t0: 0 -> 1 when rise(A); transition t1: 1 -> 2 when AT_FRONT && rise(A); }\n"
                  "closed_loop l { controller c; environment EA = push_button(OUT = A, GAP = 300ms);\n"
                  "plant P = cylinder_5_2_spring(G_OUT = G_OUT, IN = AT_BACK, OUT = AT_FRONT, STROKE_OUT = 2s,\n"
                  "STROKE_IN = 2s);\n"
                  "property p: reachable X2; }\n")
            .network);
    const Network longer = in_longer_unit(loop, abstractable_processes(loop));
    EXPECT_EQ(longer.time_unit_ms, 2000);
    EXPECT_LT(in_longest_unit(loop).time_unit_ms, 1000);
    const TimedResult found = check_timed(longer, {.timelock = false});
    ASSERT_EQ(found.verdicts.front().outcome, Outcome::Holds);
    ASSERT_TRUE(found.verdicts.front().run);
    grafverif::Run run = *found.verdicts.front().run;
    for (Move& move : run.moves)
        if (Delay* const delay = std::get_if<Delay>(&move)) delay->units *= longer.time_unit_ms / loop.time_unit_ms;
    EXPECT_TRUE(replay(loop, run));
}

/// Returns the verdict of the complete search.
Outcome outcome_in_complete_loop(const std::string& text) {
    const Network loop = expand(read_loop(text).network);
    return check_timed(observed(loop, watched(loop)), {.max_states = 100'000, .timelock = false})
        .verdicts.front()
        .outcome;
}

std::string loop(const std::string& ports, const std::string& body, const std::string& panel,
                 const std::string& property) {
    return "grafcet c {\n" + ports + "\n" + body + "}\nclosed_loop panel {\ncontroller c;\n" + panel +
           "\nproperty p: " + property + ";\n}\n";
}

/// In the instant in which X1 is activated, the operator may press B before the latch moves. Then no state with P is
/// quiescent, because the change of B has not been processed.
TEST(InputAbstraction, AnObserverOfQuiescenceObservesPendingChangesOfInputs) {
    const Verdict found = decided(
        "component latch(input SET) { initial location off; location on; urgent off -> on when SET; }\n"
        "grafcet c { input A, B; output P; initial step 0; step 1 { P; } step 2;\n"
        "transition t0: 0 -> 1 when A; transition t1: 1 -> 2 when B; }\n"
        "closed_loop panel { controller c with every_cycle; plant L = latch(SET = P);\n"
        "environment EA = push_button(OUT = A); environment EB = push_button(OUT = B);\n"
        "property p: P precedes X2 && L.on at stable; }\n",
        {.explored = 0}, {}, Grain::Atomic);
    EXPECT_EQ(found.outcome, Outcome::Violated);
}

TEST(InputAbstraction, ChoosesTheOutputsOfASelectorJointly) {
    const Verdict found = decided(
        loop("input S1, S2, A;", "initial step 0; step 1; transition t: 0 -> 1 when S1 && S2 && A;",
             "environment S = switch_2(FIRST = S1, SECOND = S2);\nenvironment B = free(OUT = A);", "reachable X1"));
    EXPECT_EQ(found.outcome, Outcome::Violated);
    ASSERT_TRUE(found.abstraction);
    EXPECT_EQ(found.abstraction->chosen, (std::vector<std::string>{"S", "B"}));
}

TEST(InputAbstraction, PropertyWithManySearchesWaitsForTheNextRound) {
    const std::string text = loop("input A; output L;",
                                  "initial step 0; step 1 { L; } step 2; transition t0: 0 -> 1 when A; "
                                  "transition t1: 1 -> 2 when !A;",
                                  "environment EA = push_button(OUT = A, GAP = 2s);", "X1 holds for 2s");
    const auto rounds_until_decided = [&](std::size_t searches) {
        const Network network = expand(read_loop(text).network);
        const Observe observe = [](const Network& of) { return observed(of, watched(of)); };
        TimedOptions options{.max_states = 10, .timelock = false};
        TimedResult result = check_timed(observe(network), options);
        result.time_passes = true;
        options.max_states = 100'000;
        InputSearch search(network, observe, options, result, {.explored = 0, .searches_per_round = searches});
        std::size_t rounds = 0;
        while (result.verdicts.front().outcome == Outcome::Unknown && rounds < 20) {
            ++rounds;
            if (!search.run(1000, {})) break;
        }
        EXPECT_EQ(result.verdicts.front().outcome, Outcome::Holds) << searches;
        return rounds;
    };
    EXPECT_EQ(rounds_until_decided(8), 1U);
    EXPECT_GT(rounds_until_decided(1), 1U);
}

TEST(InputAbstraction, TimerWithoutDurationAcceptsItsRequestAtOnce) {
    const Verdict found = decided(loop("input A; output L;",
                                       "initial step 0; step 1 { L; } step 2; step 3; transition t0: 0 -> 1 when A; "
                                       "transition t1: 1 -> 2 when 2s/X1; transition t2: 2 -> 3 when 1s/X2;",
                                       "environment EA = free(OUT = A);", "L holds at most 2s"));
    EXPECT_EQ(found.outcome, Outcome::Holds);
    ASSERT_TRUE(found.abstraction);
    EXPECT_EQ(found.abstraction->untimed, std::vector<std::string>{"T_X2_1s"})
        << "otherwise time passes after step 2 is active and before L is false";
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

/// One sampling in step 1 requires J, so that the cylinder moves, and a later sampling requires B. All other samplings
/// permit both values.
TEST(InputAbstraction, FollowsARunWithSeveralRequirementsInOneStage) {
    const Verdict found =
        decided(loop("input J, B, AT_BACK, AT_FRONT; output G_OUT;",
                     "initial step 0; step 1 { G_OUT if J; } step 2; transition t0: 0 -> 1 when !B; "
                     "transition t1: 1 -> 2 when B && AT_FRONT;",
                     "environment EJ = push_button(OUT = J);\nenvironment EB = push_button(OUT = B);\n"
                     "plant P = cylinder_5_2_spring(G_OUT = G_OUT, IN = AT_BACK, OUT = AT_FRONT);",
                     "never X2"));
    EXPECT_EQ(found.outcome, Outcome::Violated);
    ASSERT_TRUE(found.abstraction);
    EXPECT_EQ(found.abstraction->chosen, (std::vector<std::string>{"EJ", "EB"}));
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
    const Verdict found = decided(text, {.explored = 0, .rounds = 1});
    EXPECT_EQ(found.outcome, Outcome::Unknown);
    EXPECT_FALSE(found.abstraction);
}

AbstractableProcess named(const Network& network, const std::string& name) {
    for (const AbstractableProcess& process : abstractable_processes(network))
        if (network.processes[process.process].name == name) return process;
    ADD_FAILURE() << name << " is missing";
    return {};
}

const std::string follower =
    "component follower(input P; output S) { clock t; initial location off; location going invariant t <= 2s; "
    "location on with S := true; urgent off -> going when P do t := 0; timed going -> on when t == 2s do S := true; "
    "urgent on -> off when !P do S := false; }\n";

TEST(InputAbstraction, KnowsWhatEachProcessWritesAndWhichProcessesReadIt) {
    const Network network = expand(
        read_loop("grafcet c { input A, B, D; output Q; initial step 0 { Q; } step 1; transition t: 0 -> 1 when A && B "
                  "&& D && 1s/X0; }\n"
                  "component lamp_of(input P) { initial location off; location on; urgent off -> on when P; timed on "
                  "-> off; }\n" +
                  follower +
                  "closed_loop l { controller c; plant Fol = follower(P = Q, S = D); plant Lamp = lamp_of(P = B);\n"
                  "environment EA = push_button(OUT = A); environment EB = push_button(OUT = B); }\n")
            .network);
    using Valuations = std::vector<std::vector<std::int64_t>>;
    EXPECT_TRUE(named(network, "EA").autonomous);
    EXPECT_EQ(named(network, "EA").valuations, (Valuations{{0}, {1}}));
    EXPECT_TRUE(named(network, "EA").readers.empty());
    EXPECT_EQ(named(network, "EB").readers, std::vector{named(network, "Lamp").process});
    EXPECT_FALSE(named(network, "Fol").autonomous);
    EXPECT_EQ(named(network, "Fol").valuations, (Valuations{{0}, {1}})) << "for any value of Q";
    EXPECT_TRUE(named(network, "Lamp").valuations.empty()) << "it has no outputs";
    EXPECT_TRUE(named(network, "T_X0_1s").valuations.empty()) << "the PLC shares its variables";
}

TEST(InputAbstraction, LivelinessIsKnownOnlyIfAllStatesOfAnInstanceAreExplored) {
    const auto counter_to = [](const std::string& last) {
        return expand(
            read_loop("component counter(output V: int 0..5000 = 0) { clock t; initial location any; timed any -> any "
                      "when V < " +
                      last +
                      " && t >= 1s do V := V + 1, t := 0; }\n"
                      "component lamp(output L) { clock t; initial location any; timed any -> any when t >= 1s "
                      "do L := !L, t := 0; }\n"
                      "grafcet c { input N: int 0..5000; input L; output Q; initial step 0; step 1 { Q; } transition "
                      "t0: 0 -> 1 when N > 100 && L; }\n"
                      "closed_loop l { controller c; environment E = counter(V = N); environment F = lamp(L = L); }\n")
                .network);
    };
    EXPECT_FALSE(named(counter_to("20"), "E").lively) << "it stops at the last value";
    EXPECT_FALSE(named(counter_to("5000"), "E").lively) << "the last value is beyond the bound of the exploration";
    EXPECT_TRUE(named(counter_to("20"), "F").lively);
}

TEST(InputAbstraction, StoresAnInstanceThatMayLeaveItsRange) {
    const auto valuations = [](const std::string& guard) {
        const Network network =
            expand(read_loop("grafcet c { input N: int 0..2; output Q; initial step 0 { Q; } step 1; "
                             "transition t: 0 -> 1 when N == 2; }\n"
                             "component counter(input P; output V: int 0..2) { initial location any; "
                             "timed any -> any when " +
                             guard +
                             " do V := V + 1; }\n"
                             "closed_loop l { controller c; plant E = counter(P = Q, V = N); }\n")
                       .network);
        return named(network, "E").valuations.size();
    };
    EXPECT_EQ(valuations("P"), 0U);
    EXPECT_EQ(valuations("P && V < 2"), 3U);
    EXPECT_EQ(valuations("V < 2 && 4 / V > 1"), 0U) << "division by zero";
}

/// Returns a loop with an instance that copies an output of the chart to an input. The output has the range 0..`high`.
std::string copier(const std::string& high, const std::string& property) {
    return "component copier(input P: int; output V: int 0..2 = 0) { initial location any; urgent any -> any when P != "
           "V do V := P; }\n" +
           loop("input N: int 0..2; output Q: int 0.." + high + ";",
                "initial step 0; step 1 { Q := 2 on activation; } step 2; transition t0: 0 -> 1 when 1s/X0; "
                "transition t1: 1 -> 2 when N == 2;",
                "plant Copy = copier(P = Q, V = N);", property);
}

TEST(InputAbstraction, ChoosesValuesThatDependOnOtherProcesses) {
    const auto valuations = [](const std::string& high) {
        return named(expand(read_loop(copier(high, "never X2")).network), "Copy").valuations;
    };
    EXPECT_EQ(valuations("2"), (std::vector<std::vector<std::int64_t>>{{0}, {1}, {2}}));
    EXPECT_TRUE(valuations("3").empty()) << "the instance may leave its range";
    EXPECT_EQ(decided(copier("2", "never X2")).outcome, Outcome::Violated);
    EXPECT_EQ(decided(copier("2", "never X2"), {.explored = 0}, {.own_guards_only = true}).outcome, Outcome::Holds)
        << "without the premise that all values are possible, the verdict is wrong";
}

TEST(InputAbstraction, ExploresNoInstanceThatCopiesTooManyValues) {
    std::string ports, copies, inputs, buttons, bound;
    for (int k = 0; k < 40; ++k) {
        const std::string n = std::to_string(k), comma = k == 0 ? "" : ", ";
        ports += comma + "I" + n;
        inputs += comma + "O" + n;
        copies += comma + "O" + n + " := I" + n;
        bound += "I" + n + " = B" + n + ", O" + n + " = O" + n + (k == 39 ? "" : ", ");
        buttons += "environment E" + n + " = free(OUT = B" + n + ");\n";
    }
    const Network network =
        expand(read_loop("component latch(input " + ports + "; output " + inputs +
                         ") { clock t; initial location any; timed any -> any when t >= 1s do " + copies +
                         ", t := 0; }\n"
                         "grafcet c { input " +
                         inputs +
                         "; output Q; initial step 0; step 1 { Q; } transition t0: 0 -> 1 when O0 "
                         "&& O39; }\n"
                         "closed_loop l { controller c; plant Latch = latch(" +
                         bound + ");\n" + buttons + "}\n")
                   .network);
    EXPECT_EQ(named(network, "Latch").valuations.size(), 4U) << "the PLC reads two outputs";
}

TEST(InputAbstraction, ChoosesOnlyOutputsThatOtherProcessesRead) {
    // The variables of the belt have more than 4096 valuations.
    const auto belt = [](const std::string& last) {
        return expand(read_loop("component belt(input RUN; output AT_END; output LEFT: int 0..9 = 0) {\n"
                                "variable A: int 0..9 = 0; variable B: int 0..9 = 0; variable C: int 0..9 = 0;\n"
                                "clock t; initial location any;\n"
                                "timed any -> any when RUN && t >= 1s do LEFT := C, C := B, B := A, A := " +
                                last +
                                ", AT_END := C > 4, t := 0; }\n"
                                "grafcet c { input E; output Q; initial step 0 { Q; } step 1; transition t0: 0 -> 1 "
                                "when E; }\n"
                                "closed_loop l { controller c; plant Belt = belt(RUN = Q, AT_END = E, LEFT = LEFT); "
                                "property p: never LEFT == 9; }\n")
                          .network);
    };
    const AbstractableProcess found = named(belt("(A + 7) % 10"), "Belt");
    EXPECT_EQ(found.read_outputs.size(), 1U) << "only the PLC reads an output";
    EXPECT_EQ(found.outputs.size(), 5U) << "the properties of the loop may read each of them";
    EXPECT_EQ(found.valuations, (std::vector<std::vector<std::int64_t>>{{0}, {1}}));
    EXPECT_TRUE(named(belt("A + 7"), "Belt").valuations.empty()) << "the instance may leave its range";
    EXPECT_TRUE(named(belt("9 / A"), "Belt").valuations.empty()) << "a division may be undefined";
}

/// Returns a loop with a cylinder that a button starts, and another cylinder whose order ends after 3 s.
std::string two_followers(const std::string& property) {
    return follower + loop("input A, D, E; output Q, R;",
                           "initial step 0; step 1 { Q; } step 2 { R; } step 3; transition t0: 0 -> 1 when A; "
                           "transition t1: 1 -> 2 when D; transition t2: 2 -> 3 when 3s/X2; "
                           "transition t3: 3 -> 0 when !A && !E;",
                           "plant Fol = follower(P = Q, S = D);\nplant Other = follower(P = R, S = E);\n"
                           "environment EA = push_button(OUT = A);",
                           property);
}

struct LevelsOf {
    bool chosen = false, untimed = false;
};
LevelsOf levels_of(const Verdict& verdict, const std::string& name) {
    if (!verdict.abstraction) return {};
    const auto has = [&](const std::vector<std::string>& names) {
        return std::ranges::find(names, name) != names.end();
    };
    return {has(verdict.abstraction->chosen), has(verdict.abstraction->untimed)};
}

TEST(InputAbstraction, OmitsInstancesThatReadTheLoopWhereThePropertyDoesNotNeedThem) {
    const Verdict found = decided(two_followers("never Q && R"));
    EXPECT_EQ(found.outcome, Outcome::Holds);
    EXPECT_TRUE(levels_of(found, "Fol").chosen);
    EXPECT_TRUE(levels_of(found, "Other").chosen);
    EXPECT_TRUE(levels_of(found, "T_X2_3s").untimed);
}

TEST(InputAbstraction, KeepsTheLogicOfAnInstanceThatThePropertyReads) {
    const Verdict found = decided(two_followers("never R && !D && X1 at stable"));
    EXPECT_EQ(found.outcome, Outcome::Holds);
    const Verdict logic = decided(two_followers("never D && X0 at stable"));
    EXPECT_EQ(logic.outcome, Outcome::Holds);
    EXPECT_TRUE(levels_of(logic, "Fol").untimed);
    EXPECT_TRUE(levels_of(logic, "Other").chosen);
}

TEST(InputAbstraction, RaisesAnInstanceToCompleteWhereItsTimeMatters) {
    const Verdict found = decided(two_followers("X1 holds at most 2s"));
    EXPECT_EQ(found.outcome, Outcome::Holds);
    EXPECT_FALSE(levels_of(found, "Fol").chosen || levels_of(found, "Fol").untimed);
    EXPECT_TRUE(levels_of(found, "Other").chosen);
    const Verdict shorter = decided(two_followers("X1 holds at most 1s"));
    EXPECT_EQ(shorter.outcome, Outcome::Violated);
    EXPECT_TRUE(shorter.run);
}

TEST(InputAbstraction, RaisesATimerToCompleteWhereItsTimeMatters) {
    const Verdict found = decided(two_followers("X2 holds for 3s"));
    EXPECT_EQ(found.outcome, Outcome::Holds);
    EXPECT_FALSE(levels_of(found, "T_X2_3s").untimed);
    EXPECT_TRUE(levels_of(found, "Fol").chosen);
}

/// A chart that fills a tank, heats it, and drains it. The sensors read the level of the tank, which no PLC reads.
std::string heated_tank(const std::string& property) {
    return follower + loop("input A, LOW, HIGH, HOT; output FILL, HEAT, DRAIN;",
                           "initial step 0; step 1 { FILL; } step 2 { HEAT; } step 3 { DRAIN; } "
                           "transition t0: 0 -> 1 when A && !LOW; transition t1: 1 -> 2 when HIGH; "
                           "transition t2: 2 -> 3 when HOT; transition t3: 3 -> 0 when !LOW;",
                           "environment EA = free(OUT = A);\nplant H = follower(P = HEAT, S = HOT);\n"
                           "plant T = tank_level(FILL = FILL, DRAIN = DRAIN, LEVEL = LEVEL, LEVEL_max = 2);\n"
                           "plant S = level_sensors(LEVEL = LEVEL, LOW = LOW, HIGH = HIGH, LOW_min = 1, HIGH_min = 2) "
                           "initially empty;",
                           property);
}

TEST(InputAbstraction, RaisesJointlyWhatCannotPerformTheEndOfARun) {
    const Verdict found = decided(heated_tank("X3 leads to X0 within 2s"));
    EXPECT_EQ(found.outcome, Outcome::Holds);
    ASSERT_TRUE(found.abstraction);
    EXPECT_EQ(found.abstraction->chosen, (std::vector<std::string>{"EA", "H"}))
        << "the heater cannot follow the run either, but earlier in the run";
    EXPECT_EQ(decided(heated_tank("X3 leads to X0 within 1s")).outcome, Outcome::Violated);
}

TEST(InputAbstraction, ExecutesJointlyWhatAnOutputOfThePlcRelates) {
    // The guards of the probe relate the level to an output of the PLC. Without the values of this output, the states of
    // the tank and of the probe have another layout.
    const std::string text =
        "component probe(input LEVEL: int; input TEST; output LOW) { initial location dry; location wet with LOW := "
        "true; urgent dry -> wet when LEVEL >= 1 || TEST do LOW := true; urgent wet -> dry when LEVEL < 1 && !TEST do "
        "LOW := false; }\n" +
        loop("input A, LOW; output FILL, DRAIN, TEST;",
             "initial step 0; step 1 { FILL; TEST; } step 2 { DRAIN; } transition t0: 0 -> 1 when A && !LOW; "
             "transition t1: 1 -> 2 when 3s/X1; transition t2: 2 -> 0 when !LOW;",
             "environment EA = free(OUT = A);\nplant T = tank_level(FILL = FILL, DRAIN = DRAIN, LEVEL = LEVEL, "
             "LEVEL_max "
             "= 2);\nplant P = probe(LEVEL = LEVEL, TEST = TEST, LOW = LOW);",
             "X2 leads to X0 within 2s");
    EXPECT_EQ(outcome_in_complete_loop(text), Outcome::Holds);
    EXPECT_EQ(decided(text).outcome, Outcome::Holds);
}

TEST(InputAbstraction, ExaminesAnInstanceJointlyWithTheChosenInstancesThatItReads) {
    const Network network = expand(read_loop(heated_tank("never X3")).network);
    const std::vector<AbstractableProcess> instances = abstractable_processes(network);
    const auto index = [&](const std::string& name) {
        const auto at = std::ranges::find_if(
            instances, [&](const AbstractableProcess& each) { return network.processes[each.process].name == name; });
        return static_cast<std::size_t>(at - instances.begin());
    };
    const std::size_t tank = index("T"), sensors = index("S");
    std::vector<InputLevel> levels(instances.size(), InputLevel::Complete);
    levels[tank] = levels[sensors] = InputLevel::Chosen;
    std::vector<std::vector<std::size_t>> groups = joint_groups(instances, levels);
    std::ranges::sort(groups);
    std::vector<std::vector<std::size_t>> expected{
        {tank}, {sensors}, {std::min(sensors, tank), std::max(sensors, tank)}};
    std::ranges::sort(expected);
    EXPECT_EQ(groups, expected);
    levels[sensors] = InputLevel::Untimed;
    EXPECT_EQ(joint_groups(instances, levels).size(), 2U) << "the values of the tank are in the run if it is stored";
}

TEST(InputAbstraction, IgnoresQuiescenceOfOmittedInstances) {
    const std::string text = two_followers("never Q && X1 at stable");
    EXPECT_EQ(decided(text).outcome, Outcome::Violated);
    EXPECT_EQ(decided(text, {.explored = 0, .rounds = 1, .coarse_rounds = 1}, {.keep_quiescence = true}).outcome,
              Outcome::Holds)
        << "the test would not detect that the premise is violated";
}

/// Returns a loop with two buttons, whose chart changes its step infinitely often within an instant
/// while `when` holds.
std::string unstable(const std::string& when, const std::string& property) {
    return loop("input A, B; output L;",
                "initial step 0; step 1; step 2 { L; } transition t0: 0 -> 1 when A; transition t1: 1 -> 2 when !A; "
                "transition t2: 2 -> 0 when B; transition t3: 1 -> 0 when " +
                    when + ";",
                "environment EA = push_button(OUT = A);\nenvironment EB = push_button(OUT = B);", property);
}

TEST(InputAbstraction, ProvesThatTimePassesForAllValuations) {
    for (const char* property : {"no timelock", "no deadlock"}) {
        const Verdict stable = decided(unstable("!A && B", property));
        EXPECT_EQ(stable.outcome, Outcome::Holds) << property;
        ASSERT_TRUE(stable.abstraction) << property;
        ASSERT_EQ(stable.notes.size(), 1U) << property;
        EXPECT_EQ(stable.notes.front(), "proved separately for the processes and for the evolutions of the charts");
        const Verdict searched = decided(unstable("!A && B", property), {.explored = 0}, {.search_evolutions = true});
        EXPECT_EQ(searched.outcome, Outcome::Holds) << property;
        EXPECT_TRUE(searched.notes.empty()) << property;
        EXPECT_EQ(searched.abstraction->chosen.size(), 2U);
        EXPECT_EQ(decided(unstable("A && B", property)).outcome, Outcome::Unknown) << property;
        EXPECT_EQ(decided(unstable("A && B", property), {.explored = 0}, {.initial_values = true}).outcome,
                  Outcome::Holds)
            << "the test would not detect that the premise is violated";
    }
}

TEST(InputAbstraction, ProvesThatTimePassesIfASearchExcludesModelErrors) {
    // Step 1 is active only while N < 2, but the proof that evolutions end considers steps and counters separately.
    const auto counting = [](const std::string& when) {
        return loop("input A, B; output L; internal N: int 0..2;",
                    "initial step 0; step 1 { L; N := N + 1 on deactivation; } transition t0: 0 -> 1 when " + when +
                        "; transition t1: 1 -> 0 when !A;",
                    "environment EA = push_button(OUT = A);\nenvironment EB = push_button(OUT = B);", "no timelock");
    };
    const Verdict excluded = decided(counting("A && N < 2"));
    EXPECT_EQ(excluded.outcome, Outcome::Holds);
    ASSERT_EQ(excluded.notes.size(), 1U);
    EXPECT_EQ(excluded.notes.front(), "proved separately for the processes and for the evolutions of the charts");
    EXPECT_EQ(decided(counting("A")).outcome, Outcome::Unknown) << "N may leave its range";
    EXPECT_EQ(decided(counting("A"), {.explored = 0}, {.ignore_errors = true}).outcome, Outcome::Holds)
        << "the test would not detect that the premise is violated";
}

TEST(InputAbstraction, ProvesNoAbsenceOfTimelockIfAnInputFollowsAnOutputAtOnce) {
    const std::string text =
        "component echo(input P; output S) { initial location off; location on; urgent off -> on when P do S := true; "
        "urgent on -> off when !P do S := false; }\n" +
        loop("input A, D; output Q;",
             "initial step 0 { Q; } step 1; transition t0: 0 -> 1 when A && D; transition t1: 1 -> 0 when !D;",
             "plant Echo = echo(P = Q, S = D);\nenvironment EA = push_button(OUT = A);", "no timelock");
    EXPECT_EQ(decided(text).outcome, Outcome::Unknown);
    EXPECT_EQ(outcome_in_complete_loop(text), Outcome::Violated);
    EXPECT_EQ(decided(text, {.explored = 0}, {.ignore_outputs = true}).outcome, Outcome::Holds)
        << "the test would not detect that the premise is violated";
}

TEST(InputAbstraction, ProvesNoAbsenceOfTimelockIfAnEvolutionMayNotEnd) {
    const std::string text = unstable("A && B", "no timelock");
    const Verdict open = decided(text);
    EXPECT_EQ(open.outcome, Outcome::Unknown);
    ASSERT_EQ(open.notes.size(), 1U);
    EXPECT_NE(open.notes.front().find("`grafverif analyse` reports whether the chart is unstable"), std::string::npos);
    EXPECT_EQ(outcome_in_complete_loop(text), Outcome::Violated);
    EXPECT_EQ(decided(text, {.explored = 0}, {.ignore_evolutions = true}).outcome, Outcome::Holds)
        << "the test would not detect that the premise is violated";
}

/// Returns a loop with a plant of two clocks. In the location `both`, the bound that is reached first decides the next
/// location; this is always the bound of t.
std::string race_of_bounds(const std::string& property) {
    return "component two(input P; output S, F) { clock t, u; initial location off; location one invariant u <= 1s && "
           "t <= 2s; location both invariant u <= 2s && t <= 2s; location good; location bad; "
           "urgent off -> one when P do t := 0, u := 0; timed one -> both when u == 1s do u := 0; "
           "timed one -> bad when t == 2s do F := true; timed both -> bad when t == 2s do F := true; "
           "timed both -> good when u == 2s do S := true; "
           "urgent good -> off when !P do S := false; urgent bad -> off when !P do F := false; }\n" +
           loop("input A, S, F; output Q;",
                "initial step 0; step 1 { Q; } step 2; step 3; transition t0: 0 -> 1 when A; transition t1: 1 -> 2 "
                "when S; transition t2: 1 -> 3 when F; transition t3: 2 -> 0 when !S; transition t4: 3 -> 0 when !F;",
                "plant Two = two(P = Q, S = S, F = F);\nenvironment EA = push_button(OUT = A);", property);
}

TEST(InputAbstraction, ProvesThatAStateIsPossibleOnlyByAnEdgeForEachBound) {
    const std::string text = race_of_bounds("always possible X2");
    EXPECT_EQ(decided(text).outcome, Outcome::Unknown);
    EXPECT_EQ(outcome_in_complete_loop(text), Outcome::Violated);
    EXPECT_EQ(decided(text, {.explored = 0}, {.one_bound = true}).outcome, Outcome::Holds)
        << "the test would not detect that the premise is violated";
    EXPECT_EQ(decided(race_of_bounds("always possible X1")).outcome, Outcome::Holds);
}

TEST(InputAbstraction, ProvesNoResponseThatAnObserverDecides) {
    const std::string plant =
        "component follower(input P; output S) { clock t; initial location off; location going invariant t <= 2s; "
        "location on; urgent off -> going when P do t := 0; timed going -> on when t == 2s do S := true; "
        "urgent on -> off when !P do S := false; }\n";
    const auto text = [&](const std::string& property) {
        return plant + loop("input A, D; output Q;",
                            "initial step 0; step 1 { Q; } step 2; transition t0: 0 -> 1 when A; transition t1: 1 "
                            "-> 2 when D; transition t2: 2 -> 0 when !A;",
                            "plant Fol = follower(P = Q, S = D);\nenvironment EA = push_button(OUT = A);", property);
    };
    EXPECT_EQ(decided(text("X1 leads to X2")).outcome, Outcome::Holds);
    EXPECT_EQ(outcome_in_complete_loop(text("inevitable X1 after X2")), Outcome::Violated);
    EXPECT_NE(decided(text("inevitable X1 after X2")).outcome, Outcome::Holds) << "its operands are X1 and X2";
}

/// Two urgent edges of the plant can be taken alternately forever within an instant: time may pass, but need not.
TEST(InputAbstraction, ProvesNoResponseIfUrgentEdgesMayRepeat) {
    const std::string text =
        "component turning(input P; output S) { initial location off; location on; location done; "
        "urgent off -> on when P; urgent on -> off when P; urgent on -> done when P do S := true; "
        "urgent done -> off when !P do S := false; }\n"
        "component lamp(input P) { initial location off; location on; urgent off -> on when P; "
        "urgent on -> off when !P; }\n" +
        loop("input A, D; output Q;",
             "initial step 0; step 1 { Q; } step 2; transition t0: 0 -> 1 when A; transition t1: 1 -> 2 when D; "
             "transition t2: 2 -> 0 when !A;",
             "plant Fol = turning(P = Q, S = D);\nplant Lamp = lamp(P = A);\nenvironment EA = push_button(OUT = A);",
             "X1 leads to X2");
    EXPECT_EQ(outcome_in_complete_loop(text), Outcome::Violated);
    EXPECT_NE(decided(text).outcome, Outcome::Holds) << "no instance is chosen";
}

TEST(InputAbstraction, ProvesNoAbsenceOfDeadlockIfASubsystemHasNoLivelyInstance) {
    const auto text = [](const std::string& other) {
        return "component once(output OUT) { initial location off; location on; timed off -> on do OUT := true; }\n" +
               loop("input A; output L;",
                    "initial step 0; step 1 { L; } transition t0: 0 -> 1 when A; transition t1: 1 -> 0 when !A;",
                    "environment EA = push_button(OUT = A);\nenvironment Other = " + other + "(OUT = B);",
                    "no deadlock");
    };
    EXPECT_EQ(decided(text("push_button")).outcome, Outcome::Holds);
    EXPECT_NE(decided(text("once")).outcome, Outcome::Holds);
}

TEST(InputAbstraction, ProvesNoAbsenceOfDeadlockWithoutALivelyInstance) {
    const auto once = [](const std::string& property) {
        return "component once(output OUT) { initial location off; location on; timed off -> on do OUT := true; }\n" +
               loop("input A, B; output L;",
                    "initial step 0; step 1 { L; } step 2; transition t0: 0 -> 1 when A; transition t1: 1 -> 2 when B;",
                    "environment EA = once(OUT = A);\nenvironment EB = once(OUT = B);", property);
    };
    EXPECT_EQ(decided(once("no timelock")).outcome, Outcome::Holds);
    EXPECT_EQ(decided(once("no deadlock")).outcome, Outcome::Unknown);
}

/// Returns a loop with the free inputs I1..In.
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
