// SPDX-License-Identifier: MIT
// Compares the verdicts found on input abstractions with those of the complete loop, on random loops with operator
// panels. Each premise of the abstraction is omitted once, to show that the comparison detects the omission.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>

#include "check/inputs/inputs.hpp"
#include "compose/observe.hpp"
#include "pipeline/staged_search.hpp"
#include "support/random_loop.hpp"
#include "support/random_panel.hpp"
#include "support/read_loop.hpp"
#include "support/row_counts.hpp"
#include "support/test_size.hpp"
#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

constexpr std::uint64_t complete_limit = 30'000;

std::string one_of(Random& random, const std::vector<std::string>& from) {
    return from[static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(from.size()) - 1))];
}

/// An instance of the panel, with the names of its ports and the conditions on them that the chart may read.
struct Element {
    std::string instance = "", ports = "";
    std::vector<std::string> conditions = {};
};

/// Returns a loop of a chart with three steps and a panel with two or three elements: push buttons with and without a
/// bound on the time pressed, a selector, a free input, an integer input. The loop also has an actuator of the plant,
/// times and edges of inputs, and conditional, stored and counting actions. In some loops the instance `Lamp` reads a
/// button directly, or a second chart reads the same panel; the charts may read outputs of each other. The plant is one
/// of `plants`: components with an order and a sensor. In some loops a second instance reads the sensor.
std::string panel_loop(Random& random, const std::vector<std::string>& plants) {
    std::vector<Element> panel{{"environment EA = push_button(OUT = A);", "A", {"A", "rise(A)", "fall(A)", "1s/A"}},
                               {"environment EB = free(OUT = B);", "B", {"B", "rise(B)"}},
                               {"environment EP = push_button_released(OUT = P, HOLD = 2s);", "P", {"P", "fall(P)"}},
                               {"environment ES = switch_2(FIRST = S1, SECOND = S2);",
                                "S1, S2",
                                {"S1", "S2", "!S1 && !S2", "S1 && S2", "rise(S2)"}},
                               {"environment EN = level(V = N);", "N: int 0..2", {"N > 1", "N == 0", "N == 1"}}};
    if (chance(random, 20)) panel.push_back({"environment EO = once(OUT = O);", "O", {"O", "!O", "rise(O)"}});
    if (chance(random, 15)) panel.push_back({"environment EX = expiring(OUT = Z);", "Z", {"Z", "rise(Z)"}});
    while (panel.size() > 3 || (panel.size() > 2 && chance(random, 60)))
        panel.erase(panel.begin() + random_number(random, 0, static_cast<std::int64_t>(panel.size()) - 1));
    const std::string& first = panel[0].conditions[0];
    const bool two = chance(random, 20), reader = panel[0].ports == "A" && chance(random, 40);
    const bool chain = chance(random, 20), linked = two && chance(random, 60);
    std::vector<std::string> sensors{"D"};
    if (chain) sensors.emplace_back("G");
    const auto state = [&](bool edges) {
        std::string found = one_of(random, sensors);
        if (chance(random, 85)) {
            const Element& element =
                panel[static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(panel.size()) - 1))];
            found = one_of(random, element.conditions);
        }
        const bool plain = found.find('(') == std::string::npos && found.find('/') == std::string::npos;
        if (!edges && !plain) found = first;
        return (chance(random, 30) ? "!(" : "(") + found + ")";
    };
    const auto condition = [&](int step) {
        const std::string x = "X" + std::to_string(step);
        return one_of(random,
                      {state(true), state(true), state(true) + " && " + state(true), state(true) + " || " + state(true),
                       "1s/" + x, "2s/" + x + " && " + state(true), "1s/" + x + "/1s", "true"});
    };
    const auto actions = [&](const std::string& lamp, const std::string& order) {
        return one_of(random,
                      {"", lamp + ";", lamp + " if " + state(false) + ";", lamp + "; " + order + ";",
                       order + " if " + state(false) + ";", "C := C + 1 on activation;", "C := 0 on activation;",
                       "M := true on activation;", "M := false on deactivation;", lamp + " after 1s;"});
    };
    const auto chart = [&](const std::string& name, const std::string& lamp, const std::string& order,
                           const std::string& other) {
        if (linked) sensors.push_back(other);
        std::string text = "grafcet " + name + " {\n";
        for (const std::string& sensor : sensors) text += "input " + sensor + ";\n";
        for (const Element& element : panel) text += "input " + element.ports + ";\n";
        text += "output " + lamp + ", " + order + "; internal C: int 0..2 = 0; internal M;\n";
        for (int step = 0; step < 3; ++step)
            text += (step == 0 ? "initial step 0 { " : "step " + std::to_string(step) + " { ") + actions(lamp, order) +
                    " }\n";
        for (int step = 0; step < 3; ++step)
            text += "transition t" + std::to_string(step) + ": " + std::to_string(step) + " -> " +
                    std::to_string((step + 1) % 3) + " when " + condition(step) + ";\n";
        if (chance(random, 50)) text += "transition back: 1 -> 0 when " + condition(1) + ";\n";
        if (linked) sensors.pop_back();
        return text + "}\n";
    };
    std::string text = chart("c", "L", "Q", "K") + (two ? chart("d", "K", "R", "L") : "");
    text +=
        "component follower(input P; output S) { clock t; initial location off; location going invariant t <= 1s; "
        "location on; urgent off -> going when P do t := 0; timed going -> on when t == 1s do S := true; "
        "urgent on -> off when !P do S := false; }\n"
        "component echo(input P; output S) { initial location off; location on; urgent off -> on when P do S := true; "
        "urgent on -> off when !P do S := false; }\n"
        "component stuck(input P; output S) { clock t; initial location off; location going invariant t <= 1s; "
        "location on; urgent off -> going when P do t := 0; timed going -> on when P && t == 1s do S := true; "
        "urgent on -> off when !P do S := false; }\n"
        "component spin(input P; output S) { clock t; initial location off; location on; urgent off -> on when P; "
        "urgent on -> off when P; timed on -> off when t >= 1s do S := !S, t := 0; }\n"
        "component race(input P; output S) { clock t, u; initial location off; location one invariant u <= 1s && "
        "t <= 2s; location both invariant u <= 2s && t <= 2s; location good; location bad; "
        "urgent off -> one when P do t := 0, u := 0; timed one -> both when u == 1s do u := 0; "
        "timed one -> bad when t == 2s; timed both -> bad when t == 2s; timed both -> good when u == 2s do S := true; "
        "urgent bad -> off when !P; urgent good -> off when !P do S := false; }\n"
        "component early(input P; output S) { clock t; initial location off; location wait; location on; "
        "urgent off -> wait when P do t := 0; timed wait -> on when t <= 1s do S := true; "
        "urgent on -> off when !P do S := false; }\n"
        "component counter(input P; output S) { variable N: int 0..2; clock t; initial location off; location on; "
        "urgent off -> on when P do t := 0; timed on -> on when P && t >= 1s do N := N + 1, S := true, t := 0; "
        "urgent on -> off when !P do N := 0, S := false; }\n"
        "component tracker(input P; output S) { variable B: bool = false; initial location any; "
        "urgent any -> any when P != B do S := B, B := P; }\n"
        "component level(output V: int 0..2) { clock t; initial location any; "
        "timed any -> any when V < 2 && t >= 1s do V := V + 1, t := 0; timed any -> any when V > 0 do V := V - 1; }\n"
        "component expiring(output OUT) { clock t; initial location off; location on invariant t <= 3s; "
        "timed off -> on when t >= 1s do OUT := true, t := 0; }\n"
        "component once(output OUT) { initial location off; location on; timed off -> on do OUT := true; }\n"
        "component pulse(input P) { initial location off; location on; urgent off -> on when P; timed on -> off; }\n";
    text += "closed_loop panel {\ncontroller c" + std::string(chance(random, 30) ? " with every_cycle" : "") + ";\n";
    if (two) text += "controller d;\n";
    text += "plant Fol = " + one_of(random, plants) + "(P = Q, S = D);\n";
    if (chain) text += "plant Seen = " + one_of(random, {"echo", "echo", "follower"}) + "(P = D, S = G);\n";
    if (reader) text += "plant Lamp = pulse(P = A);\n";
    for (const Element& element : panel) text += element.instance + "\n";
    const auto atom = [&] {
        return one_of(random, {"c.X0", "c.X1", "c.X2", "L", "Q", "D", "(c.C == 2)", "c.M", state(false),
                               reader ? "Lamp in on" : "L"});
    };
    const auto term = [&] { return atom() + one_of(random, {" && ", " || ", " && !"}) + "(" + atom() + ")"; };
    const std::string when = one_of(random, {"", " at stable"});
    text += "property p1: never " + term() + when + ";\nproperty p2: always " + term() + ";\nproperty p3: reachable " +
            term() + when +
            ";\nproperty p4: exactly one of {c.X0, c.X1, c.X2};\n"
            "property p5: reachable all steps;\nproperty d: no deadlock;\nproperty g1: always possible " +
            term() + when + ";\nproperty g2: always possible " + atom() + ";\nproperty g3: (" + atom() +
            ") leads to (" + term() + ");\nproperty g4: inevitable " + term() +
            ";\nproperty p6: never c.X1 && L && !Q" + when + ";\n";
    const std::string half = chance(random, 25) ? "1500ms" : "";  // not a multiple of the other durations
    text += "property w1: " +
            one_of(random, {"(" + atom() + ") leads to (" + term() + ") within " + (half.empty() ? "2s" : half),
                            "(" + atom() + ") holds for " + (half.empty() ? "1s" : half),
                            "(" + atom() + ") holds at most " + (half.empty() ? "2s" : half),
                            "never " + atom() + " between (" + atom() + ") and (" + atom() + ")",
                            "(" + atom() + ") at most 2 times", "(" + atom() + ") precedes (" + atom() + ")"}) +
            ";\nproperty w2: " +
            one_of(random, {"inevitable (" + atom() + ")", "(" + atom() + ") leads to (" + atom() + ")"}) +
            one_of(random, {" before (" + atom() + ")", " after (" + atom() + ")", " after (" + atom() + ")",
                            " after (" + atom() + ") until (" + atom() + ")"}) +
            ";\n";
    return text + "}\n";
}

/// True if the property holds and has a pattern that a search in integer time cannot always prove.
bool is_progress(const Network& network, const Verdict& verdict) {
    if (!verdict.about.valid() || verdict.outcome != Outcome::Holds) return false;
    const Pattern pattern = network.properties[verdict.about].pattern;
    return pattern == Pattern::AlwaysPossible || pattern == Pattern::LeadsTo || pattern == Pattern::Inevitable;
}

/// Compares the verdicts of the input abstractions with those of the complete search.
struct Compared {
    int wrong = 0;
    std::map<std::string, int>& seen;

    /// Checks that a property that holds is not violated with a finer time unit. For n clocks, the unit 1 / (n + 1) is
    /// sufficient.
    void compare_finer(const Network& network, const Verdict& here, bool expected) {
        const bool possible = network.properties[here.about].pattern == Pattern::AlwaysPossible;
        const std::string name = possible ? "always possible" : "leads to";
        ++seen[name];
        ++seen["verdicts on " + here.property];
        if (std::ranges::any_of(here.notes,
                                [](const std::string& note) { return note.starts_with("from every state"); }))
            ++seen["with a homing sequence"];
        for (const std::int64_t factor : {1, 2, 3, 5}) {
            const TimedResult finer = check_timed(refined(network, factor),
                                                  {.properties = {here.property}, .max_states = 4 * complete_limit});
            const bool differs = verdict(finer, here.property).outcome == Outcome::Violated;
            wrong += differs ? 1 : 0;
            seen[name + " in finer time"] += finer.complete ? 1 : 0;
            if (expected) {
                EXPECT_FALSE(differs) << here.property << " with a time unit divided by " << factor;
            }
            if (!finer.complete || differs) return;
        }
    }

    void compare(const Network& network, const TimedResult& complete, const TimedResult& inputs, bool expected) {
        for (std::size_t i = 0; i < inputs.verdicts.size(); ++i) {
            const Verdict& here = inputs.verdicts[i];
            const Verdict& there = complete.verdicts[i];
            const bool faulty = there.obstacle == UnknownReason::Faulty;
            if (here.abstraction && is_progress(network, here) && !faulty) compare_finer(network, here, expected);
            if (!here.abstraction || (there.outcome == Outcome::Unknown && !faulty)) continue;
            if (!is_progress(network, here)) ++seen["verdicts on " + here.property];
            ++seen[std::string(word(here.outcome)) + (here.run ? " with a run" : " without a run")];
            if (*here.abstraction == InputsAbstracted{} && here.run) ++seen["with a run of the novelty search"];
            if (here.run && here.run->loop) ++seen["with a run to a state of rest"];
            if (here.property == "no_timelock" || here.property == "d") ++seen[here.property];
            seen["evolutions end"] += static_cast<int>(std::ranges::count(
                here.notes, "proved separately for the processes and for the evolutions of the charts"));
            if (!here.abstraction->untimed.empty()) ++seen["with untimed instances"];
            if (std::ranges::any_of(here.notes,
                                    [](const std::string& note) { return note.find("rounded") != note.npos; }))
                ++seen["rounded"];
            const auto& chosen = here.abstraction->chosen;
            if (std::ranges::find(chosen, "Fol") != chosen.end()) ++seen["with a chosen plant"];
            const bool differs = faulty ? !here.run : here.outcome != there.outcome;
            wrong += differs ? 1 : 0;
            if (!expected) continue;
            EXPECT_FALSE(differs) << here.property << ": abstraction " << word(here.outcome) << ", complete "
                                  << word(there.outcome);
            EXPECT_FALSE(here.vacuous && !there.vacuous) << here.property;
            if (here.run) {
                EXPECT_TRUE(replay(network, *here.run)) << here.property;
            }
            if (here.run && network.properties[here.about].pattern != Pattern::ReachableAllSteps)
                confirm(network, network.properties[here.about], here);
        }
    }
};

/// Compares all properties of a loop; returns the number of wrong verdicts.
int compare(const Network& loop, const InputAblations& ablations, bool expected, std::map<std::string, int>& seen,
            std::uint64_t explored = 0, const StateProver& prove = {}) {
    Compared compared{0, seen};
    std::vector<std::vector<Id<Property>>> groups{{}};
    for (const Id<Property> id : watched(loop)) groups.push_back({id});
    for (const std::vector<Id<Property>>& group : groups) {
        const Observe observe = [&](const Network& of) {
            Network made = observed(of, group);
            if (group.empty()) return made;
            const Property only = *std::ranges::find(made.properties, loop.properties[group[0]].name, &Property::name);
            made.properties = {};
            made.properties.add(only);
            return made;
        };
        const Network network = observe(loop);
        const TimedResult complete = check_timed(network, {.max_states = complete_limit, .timelock = group.empty()});
        if (!complete.complete) continue;
        ++seen["searches compared"];
        TimedOptions options{.max_states = 3, .timelock = group.empty()};
        TimedResult inputs = check_timed(network, options);
        if (inputs.complete) continue;
        // The complete search provides the result that a longer first search would find.
        inputs.time_passes = complete.time_passes;
        options.max_states = complete_limit;
        InputSearch search(loop, observe, options, inputs,
                           {.followed = 20'000, .explored = explored, .symbolic_from = 0, .symbolic_share = 1e9},
                           ablations, prove);
        for (const std::uint64_t states : {std::uint64_t{30}, options.max_states})
            if (!search.run(states, {})) break;
        compared.compare(network, complete, inputs, expected);
    }
    return compared.wrong;
}

const std::vector<std::string> plants{"follower", "follower", "follower", "follower", "stuck",
                                      "race",     "early",    "counter",  "tracker"};

Network panel_network(std::uint64_t seed, const std::vector<std::string>& of = plants) {
    Random random(seed);
    return expand(read_loop(panel_loop(random, of), {.grain = seed % 2 == 0 ? Grain::Atomic : Grain::Phased}).network);
}

/// Compares the valuations of each instance with the reachable states of the complete loop. The belt copies values of
/// another process, and has too many states to be explored for arbitrary values of this process.
TEST(InputAbstraction, ValuationsContainTheReachableOutputs) {
    std::map<std::string, int> seen;
    for (int seed = 1; seed <= test_size(60) && !testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const std::string most = one_of(random, {"1", "3", "15"});
        const Network network = expand(
            read_loop(
                "component source(output V: int 0..15 = 0) { clock t; initial location any; timed any -> any when "
                "t >= 1s && V < " +
                    most + " do V := V + " + one_of(random, {"1", "2"}) +
                    ", t := 0; timed any -> any when V > 0 do V := 0; }\n"
                    "component belt(input P, N: int; output S; output E: int 0..15 = 0) { clock t;\n"
                    "variable A: int 0..15 = 0; variable B: int 0..15 = 0; variable C: int 0..15 = 0;\n"
                    "initial location any; " +
                    one_of(random, {"timed any -> any when t >= 1s do ", "timed any -> any when P && t >= 2s do "}) +
                    "E := C, C := B, B := A, A := " + one_of(random, {"N", "15 - N", "(N + A) % 16"}) +
                    ", S := " + one_of(random, {"C > 2", "A == B", "P"}) +
                    ", t := 0; }\n"
                    "component tracker(input N: int; output V: int 0..15 = 0) { initial location any; "
                    "urgent any -> any when V != N do V := N; }\n"
                    "grafcet c { input S, A; input W: int 0..15; output Q; initial step 0; step 1 { Q; }\n"
                    "transition t0: 0 -> 1 when S || A; transition t1: 1 -> 0 when W > 1; }\n"
                    "closed_loop l { controller c; environment Source = source(V = V); environment E = free(OUT = A);\n"
                    "plant Belt = belt(P = Q, N = V, S = S, E = F); plant Copy = tracker(N = F, V = W); }\n",
                {.grain = seed % 2 == 0 ? Grain::Atomic : Grain::Phased})
                .network);
        const std::vector<AbstractableProcess> processes = abstractable_processes(network);
        TimedOptions options{.max_states = 100'000, .timelock = false, .covering = false};
        options.each_state = [&](const NetworkState& state) {
            for (const AbstractableProcess& process : processes) {
                if (process.valuations.empty()) continue;
                std::vector<std::int64_t> values;
                for (const Id<Network::Variable> output : process.read_outputs)
                    values.push_back(state.variables[output.index]);
                EXPECT_TRUE(std::ranges::find(process.valuations, values) != process.valuations.end())
                    << network.processes[process.process].name;
                ++seen[network.processes[process.process].name];
            }
        };
        seen["complete"] += check_timed(network, options).complete ? 1 : 0;
    }
    print_counts(seen);
    EXPECT_GT(seen["complete"], test_size(10));
    EXPECT_GT(seen["Belt"], test_size(100));
    EXPECT_GT(seen["Copy"], test_size(100));
}

TEST(InputAbstraction, PanelLoopsGetTheVerdictsOfTheCompleteLoop) {
    std::map<std::string, int> seen;
    for (int seed = 1; seed <= test_size(60) && !testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        compare(panel_network(static_cast<std::uint64_t>(seed)), {.search_evolutions = seed % 3 == 0}, true, seen,
                seed % 4 < 2 ? 0 : 2000);
    }
    print_counts(seen);
    EXPECT_GT(seen["holds without a run"], test_size(5));
    EXPECT_GT(seen["violated with a run"], test_size(5));
    EXPECT_GT(seen["with a run of the novelty search"], test_size(5));
    EXPECT_GT(seen["with a run to a state of rest"], test_size(2));
    EXPECT_GT(seen["with a chosen plant"], test_size(5));
    EXPECT_GT(seen["no_timelock"], test_size(5));
    EXPECT_GT(seen["evolutions end"], test_size(2));
    EXPECT_GT(seen["d"], test_size(5));
    EXPECT_GT(seen["rounded"], 0);
    EXPECT_GT(seen["always possible in finer time"], test_size(10));
    EXPECT_GT(seen["leads to in finer time"], test_size(10));
    EXPECT_GT(seen["with a homing sequence"], 0);
}

/// Tests panels of random elements: operator components of the library, and other instances, some of which read each
/// other (support/random_panel.hpp).
TEST(InputAbstraction, LibraryPanelsGetTheVerdictsOfTheCompleteLoop) {
    std::map<std::string, int> seen;
    for (int seed = 1; seed <= test_size(40) && !testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const std::string text = random_panel(random, {.faulty = chance(random, 10), .progress = true});
        const Grain grain = chance(random, 50) ? Grain::Atomic : Grain::Phased;
        compare(expand(read_loop(text, {.grain = grain}).network), {}, true, seen, seed % 4 < 2 ? 0 : 2000);
    }
    print_counts(seen);
    EXPECT_GT(seen["holds without a run"], test_size(3));
    EXPECT_GT(seen["always possible in finer time"], 0);
    EXPECT_GT(seen["with a homing sequence"], 0);
}

TEST(InputAbstraction, RandomLoopsGetTheVerdictsOfTheCompleteLoop) {
    std::map<std::string, int> seen;
    for (int seed = 1; seed <= test_size(150) && !testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        try {
            compare(expand(composed_loop(random_loop(random)).network), {}, true, seen, seed % 4 < 2 ? 0 : 2000);
        } catch (const std::invalid_argument&) {
            ++seen["cannot be composed"];
        }
    }
    print_counts(seen);
    EXPECT_GT(seen["holds without a run"], test_size(5));
    EXPECT_GT(seen["violated with a run"], test_size(5));
}

TEST(InputAbstraction, SymbolicProofsAgreeWithTheCompleteLoop) {
    std::map<std::string, int> seen;
    for (int seed = 1; seed <= test_size(60) && !testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed) + 5000);
        const auto loop =
            read_loop(panel_loop(random, plants), {.grain = seed % 2 == 0 ? Grain::Atomic : Grain::Phased});
        const StateProver by_pdr = prover_by_pdr(translator_of_abstractions(loop.model, {0}));
        const StateProver prove = [&](const ProofTask& task) {
            const Proof proof = by_pdr({task.abstraction, task.property, {}, {}, task.memory, task.stop});
            ++seen["proofs: " + std::string(word(proof.outcome))];
            if (proof.run) {
                EXPECT_TRUE(replay(task.abstraction, *proof.run));
                ++seen["proofs with a run"];  // the proof contains no run that ends with a model error
            }
            return proof;
        };
        compare(expand(loop.network), {}, true, seen, 0, prove);
    }
    print_counts(seen);
    EXPECT_GT(seen["proofs: holds"], test_size(10));
    EXPECT_GT(seen["proofs: violated"], test_size(10));
    EXPECT_GT(seen["proofs with a run"], test_size(10));
    EXPECT_GT(seen["proofs: unknown"], 0);
}

TEST(InputAbstraction, EachPremiseIsNeeded) {
    struct Premise {
        const char* name = "";
        bool InputAblations::*omitted = nullptr;
        std::vector<std::string> plants = {"follower"};
        std::uint64_t first = 1001;  // seed of the first loop
    };
    std::map<std::string, int> last;  // seed of the loop with a wrong verdict
    for (const Premise& premise :
         {Premise{"a change of an input begins a cycle", &InputAblations::no_cycle_on_change, {"follower"}, 1121},
          Premise{"all reachable values are chosen", &InputAblations::initial_values},
          Premise{"readers see the instance", &InputAblations::ignore_readers},
          Premise{"nothing reads dead values", &InputAblations::ignore_readings},
          Premise{"guards on other variables may hold", &InputAblations::own_guards_only},
          Premise{"an abstracted instance can rest", &InputAblations::all_can_rest, {"follower"}, 1061},
          Premise{"bounds are left", &InputAblations::ignore_bounds, {"stuck"}},
          Premise{"edges that wait are not urgent", &InputAblations::urgent_on_clocks},
          Premise{"urgent edges end", &InputAblations::ignore_moves, {"spin"}},
          Premise{"evolutions end", &InputAblations::ignore_evolutions},
          Premise{"each bound may be the first", &InputAblations::one_bound, {"race"}, 1036},
          Premise{"moves depend on no clock", &InputAblations::any_edge, {"early"}, 1036},
          Premise{"bounds of observers become weaker", &InputAblations::round_inward},
          Premise{"time diverges", &InputAblations::need_not_diverge, {"stuck"}, 1131},
          Premise{"moves take time", &InputAblations::need_not_take_time, {"follower"}, 1076},
          Premise{"the panel returns", &InputAblations::need_not_return, {"follower"}, 1081}}) {
        InputAblations ablations;
        ablations.*premise.omitted = true;
        std::map<std::string, int> seen;
        int wrong = 0;
        std::uint64_t seed = premise.first;
        for (; wrong == 0 && seed < premise.first + 200; ++seed)
            wrong += compare(panel_network(seed, premise.plants), ablations, false, seen);
        EXPECT_GT(wrong, 0) << premise.name;
        last[premise.name] = static_cast<int>(seed) - 1;
    }
    print_counts(last);
}

}  // namespace
}  // namespace grafverif
