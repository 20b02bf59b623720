// SPDX-License-Identifier: MIT
// Compares the PDR engine and BMC with an explicit search and the symbolic engine, on random systems and on random
// loops in every approach and schedule. The faults and verdicts must be equal, and all runs must be valid. Runs
// reported as shortest must be shortest, and lengths that BMC excludes must be impossible. A certificate with a removed
// part must be rejected.
#include "check/pdr/pdr.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "check/pdr/check.hpp"
#include "check/pdr/latch_pairs.hpp"
#include "check/symbolic/symbolic.hpp"
#include "ir/patterns.hpp"
#include "pipeline/check.hpp"
#include "run/project.hpp"
#include "run/replay.hpp"
#include "support/explicit_search.hpp"
#include "support/random_loop.hpp"
#include "support/random_system.hpp"
#include "support/read_loop.hpp"
#include "support/test_size.hpp"
#include "support/untimed_loop.hpp"

namespace grafverif {
namespace {

using System = TransitionSystem;

struct Compared {
    std::size_t systems = 0, verdicts = 0, violated = 0, faults = 0, given_up = 0;
    std::size_t bounded = 0;  ///< number of verdicts that BMC did not determine within its step limit
};

/// Time limit of each engine, because the engines need minutes for some small models.
constexpr std::chrono::milliseconds time_limit(200);

bool gave_up(const std::vector<Verdict>& verdicts) {
    return std::ranges::any_of(verdicts,
                               [](const Verdict& verdict) { return verdict.obstacle == UnknownReason::Stopped; });
}

PdrResult patient(const System& system, PdrOptions options = {}) {
    options.deadline = std::chrono::steady_clock::now() + time_limit;
    return check_pdr(system, options);
}

bool says(const std::vector<std::string>& notes, const char* what) {
    return std::ranges::find(notes, what) != notes.end();
}

/// Compares the runs of BMC with at most `steps` steps with those of the symbolic engine, which are shortest.
void compare_bounded(const System& system, const SymbolicResult& symbolic, std::size_t steps, Compared& compared) {
    PdrOptions options;
    options.method = PdrOptions::Method::Bmc;
    options.max_steps = steps;
    const PdrResult found = patient(system, options);
    ASSERT_EQ(found.failures, std::vector<std::string>{});
    if (gave_up(found.verdicts)) return;
    for (std::size_t i = 0; i < found.verdicts.size(); ++i) {
        const Verdict &verdict = found.verdicts[i], &expected = symbolic.verdicts[i];
        SCOPED_TRACE(verdict.property);
        if (!is_about_single_states(verdict.pattern) || expected.obstacle != UnknownReason::None) continue;
        if (symbolic.runs[i] && symbolic.runs[i]->states.size() <= steps + 1) {
            ASSERT_EQ(verdict.outcome, expected.outcome);
            EXPECT_EQ(found.runs[i]->states.size(), symbolic.runs[i]->states.size());
            EXPECT_TRUE(says(verdict.notes, "no shorter trace exists"));
            continue;
        }
        EXPECT_EQ(verdict.outcome, Outcome::Unknown);
        EXPECT_EQ(verdict.obstacle, UnknownReason::Bound);
        EXPECT_EQ(verdict.reason,
                  "no run of up to " + std::to_string(steps) + (steps == 1 ? " step" : " steps") +
                      (verdict.pattern == Pattern::Reachable ? " satisfies the property" : " violates the property"));
        ++compared.bounded;
    }
}

/// Compares the results with those of the symbolic engine, and with `graph` if it is given. The engine does not detect
/// dead ends, so the results for a system with a dead end are compared with the graph only.
void compare(const System& system, const std::optional<SystemGraph>& graph, const PdrResult& found,
             Compared& compared) {
    const SymbolicResult symbolic = check_symbolic(system, {.deadline = std::chrono::steady_clock::now() + time_limit});
    if (gave_up(found.verdicts) || gave_up(symbolic.verdicts)) {
        ++compared.given_up;
        return;
    }
    ASSERT_EQ(found.failures, std::vector<std::string>{});
    ++compared.systems;
    const bool dead_end = symbolic.fault && symbolic.fault->kind == SystemFault::Kind::DeadEnd;
    ASSERT_TRUE(graph || !dead_end) << "this model must not have a dead end";
    ASSERT_EQ(found.fault.has_value(), symbolic.fault.has_value() && !dead_end);
    if (found.fault) {
        ++compared.faults;
        EXPECT_EQ(found.fault->kind, symbolic.fault->kind);
        return;
    }
    ASSERT_EQ(found.verdicts.size(), system.properties.size());
    for (const Id<Property> id : system.properties.ids()) {
        const Property& property = system.properties[id];
        SCOPED_TRACE(property.name);
        const Verdict& verdict = found.verdicts[id.index];
        ASSERT_EQ(verdict.property, property.name);
        if (!is_about_single_states(property.pattern)) {
            EXPECT_EQ(verdict.obstacle, UnknownReason::Unsupported);
            continue;
        }
        const bool expected =
            graph ? explicit_verdict(system, *graph, property) : symbolic.verdicts[id.index].outcome == Outcome::Holds;
        ASSERT_EQ(verdict.outcome, expected ? Outcome::Holds : Outcome::Violated);
        ASSERT_EQ(found.runs[id.index].has_value(), expected == (property.pattern == Pattern::Reachable));
        if (!dead_end) {
            ASSERT_EQ(verdict.outcome, symbolic.verdicts[id.index].outcome);
            ASSERT_EQ(verdict.vacuous, symbolic.verdicts[id.index].vacuous);
            if (found.runs[id.index] && says(verdict.notes, "no shorter trace exists")) {
                ASSERT_EQ(found.runs[id.index]->states.size(), symbolic.runs[id.index]->states.size());
            }
        }
        ++compared.verdicts;
        if (!expected) ++compared.violated;
    }
    if (!dead_end) compare_bounded(system, symbolic, compared.systems % 7, compared);
}

TEST(RandomizedPdr, AgreesWithTheOtherEnginesOnRandomSystems) {
    Compared compared;
    std::size_t by_bmc = 0;
    for (int seed = 1; seed <= test_size(400); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        System system = random_system(random);
        ask_more(system, random);
        const auto graph = explored(system, 400);
        if (!graph) continue;
        PdrOptions options;
        if (seed % 2 == 0) {
            options.method = PdrOptions::Method::Alternating;
            options.first_step_of = std::chrono::microseconds(10);
        }
        options.equal_latches = seed % 3 == 0;
        const PdrResult found = patient(system, options);
        for (const Verdict& verdict : found.verdicts) by_bmc += says(verdict.notes, "decided by bmc") ? 1U : 0U;
        ASSERT_NO_FATAL_FAILURE(compare(system, graph, found, compared));
    }
    std::cout << compared.systems << " systems, " << compared.verdicts << " verdicts, " << compared.violated
              << " of them violated, " << compared.faults << " faults, " << compared.bounded
              << " not decided within a bound, " << by_bmc << " decided by bmc\n";
    EXPECT_GT(by_bmc, 10u);
    EXPECT_GT(compared.violated, compared.verdicts / 5);
    EXPECT_GT(compared.bounded, 0u);
    EXPECT_GT(compared.faults, 0u);
}

TEST(RandomizedPdr, AgreesWithTheOtherEnginesOnRandomLoopsAndItsRunsReplay) {
    Compared compared;
    std::size_t replayed = 0;
    for (int seed = 1; seed <= test_size(2); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop(random);
        std::vector<const Chart*> charts;
        for (const ClosedLoop::Controller& controller : model.loops[{0}].controllers)
            charts.push_back(&model.charts[controller.chart]);
        for (System& system : untimed_models(model)) {
            SCOPED_TRACE(system.scope);
            query_steps(system);
            const PdrResult result = patient(system);
            ASSERT_NO_FATAL_FAILURE(compare(system, {}, result, compared));
            for (const auto& run : result.runs) {
                if (!run) continue;
                const auto found = disagreement(project(system, *run), charts);
                ASSERT_FALSE(found) << "step " << found->move << ", " << found->where << ": " << found->what;
                ++replayed;
            }
        }
    }
    std::cout << compared.systems << " models, " << compared.verdicts << " verdicts, " << replayed << " runs replayed, "
              << compared.given_up << " not decided\n";
    EXPECT_GT(compared.verdicts, 0u);
    EXPECT_GT(replayed, 0u);
}

TEST(RandomizedPdr, AgreesWithTheOtherEnginesOnASmallLoopInEveryApproachAndSchedule) {
    const Model model =
        read_loop(
            "grafcet lamp { input PRESS; output LIGHT; initial step 0; step 1 { LIGHT; }\n"
            "transition t0: 0 -> 1 when PRESS; transition t1: 1 -> 0 when !PRESS; }\n"
            "closed_loop room { controller lamp; environment a = push_button(OUT = PRESS);\n"
            "property shown: reachable LIGHT; property pressed: reachable PRESS at stable; property both: reachable X0 "
            "&& X1;\n"
            "property follows: always PRESS || !LIGHT at stable; property one: exactly one of { X0, X1 }; }\n")
            .model;
    Random random(7);
    Compared compared;
    for (System& system : untimed_models(model)) {
        SCOPED_TRACE(system.scope);
        ask_more(system, random);
        const auto graph = explored(system, 400);
        if (!graph) continue;
        ASSERT_NO_FATAL_FAILURE(compare(system, graph, patient(system), compared));
    }
    std::cout << compared.systems << " models, " << compared.verdicts << " verdicts, " << compared.given_up
              << " not decided\n";
    EXPECT_GT(compared.systems, 5u);
    EXPECT_GT(compared.violated, 5u);
}

TEST(RandomizedPdr, PairsOfLatchesAreInvariantsAndChangeNoVerdict) {
    std::size_t pairs = 0, reached = 0, unreached = 0, proofs = 0;
    for (int seed = 1; seed <= test_size(150); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        System system = random_system(random);
        ask_more(system, random);
        FlatSystem flat = flattened(system);
        const Circuit circuit = circuit_of(system, flat).circuit;
        pdr::LimitMonitor watch({});
        pdr::LatchPairs search(circuit, watch);
        const std::vector<pdr::Cube>& cubes = search.cubes();
        ASSERT_EQ(pdr::flaw(circuit, Gates::no, cubes, watch), "");
        pairs += cubes.size();
        const std::vector<pdr::NamedCube> named = search.named_cubes();
        pdr::LatchPairs again(circuit, watch, &named);
        if (!named.empty()) {
            ASSERT_EQ(again.cubes(), cubes) << "the pairs are candidates that the search confirms";
        }
        for (const Circuit::Target& target : circuit.targets) {
            if (!target.justice.empty()) continue;
            const pdr::PdrAnswer plain = pdr::reach(circuit, target.bad, watch);
            const pdr::KnownInvariant known{[&]() -> const std::vector<pdr::Cube>& { return cubes; }, 0};
            const pdr::PdrAnswer answer = pdr::reach(circuit, target.bad, watch, {}, known);
            ASSERT_EQ(answer.reached, plain.reached);
            ++(answer.reached ? reached : unreached);
            if (answer.reached) continue;
            ASSERT_EQ(pdr::flaw(circuit, target.bad, answer.invariant, watch), "");
            proofs += pdr::flaw(circuit, target.bad, cubes, watch).empty() ? 1U : 0U;
        }
    }
    std::cout << pairs << " pairs, " << reached << " targets reached, " << unreached << " not reached, " << proofs
              << " of them excluded by pairs alone\n";
    EXPECT_GT(pairs, 500u);
    EXPECT_GT(reached, 50u);
    EXPECT_GT(proofs, 10u);
}

TEST(RandomizedPdr, InvariantsWithoutAClauseOrLiteralAreCheckedAgain) {
    std::size_t whole = 0, rejected = 0;
    for (int seed = 1; seed <= test_size(150); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        System system = random_system(random);
        ask_more(system, random);
        FlatSystem flat = flattened(system);
        const Circuit circuit = circuit_of(system, flat).circuit;
        pdr::LimitMonitor watch({});
        for (const Circuit::Target& target : circuit.targets) {
            if (!target.justice.empty()) continue;
            const pdr::PdrAnswer answer = pdr::reach(circuit, target.bad, watch);
            if (answer.reached) {
                EXPECT_NE(pdr::flaw(circuit, target.bad, {}, watch), "") << "a reachable target has no certificate";
                continue;
            }
            ASSERT_EQ(pdr::flaw(circuit, target.bad, answer.invariant, watch), "");
            ++whole;
            for (std::size_t i = 0; i < answer.invariant.size(); ++i) {
                std::vector<pdr::Cube> damaged = answer.invariant;
                if (damaged[i].size() > 1) damaged[i].pop_back();
                else damaged.erase(damaged.begin() + static_cast<std::ptrdiff_t>(i));
                rejected += pdr::flaw(circuit, target.bad, damaged, watch).empty() ? 0U : 1U;
                damaged = answer.invariant;
                damaged[0] = {};
                EXPECT_EQ(pdr::flaw(circuit, target.bad, damaged, watch), "the invariant excludes an initial state");
            }
        }
    }
    std::cout << whole << " invariants, " << rejected << " damaged invariants rejected\n";
    EXPECT_GT(whole, 50u);
    EXPECT_GT(rejected, 50u);
}

/// Returns a search that gives the correct result or one of two wrong results. The search always
/// reports that a quiescent state is reached.
decltype(PdrOptions::reach) liar(Random& random) {
    return [&random](const Circuit& circuit, Gates::Literal bad, pdr::LimitMonitor& watch) -> pdr::PdrAnswer {
        const std::int64_t choice = bad == circuit.settled ? 0 : static_cast<std::int64_t>(random() % 4);
        if (choice == 0) return {.reached = true, .inputs = {std::vector<bool>(circuit.inputs.size())}};
        if (choice == 1) return {};
        return pdr::reach(circuit, bad, watch);
    };
}

TEST(RandomizedPdr, WrongResultsOfASearchNeverBecomeVerdicts) {
    std::size_t believed = 0, doubted = 0, vacuous = 0, faults = 0;
    for (int seed = 1; seed <= test_size(400); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        System system = random_system(random);
        ask_more(system, random);
        PdrOptions options;
        options.reach = liar(random);
        const PdrResult honest = check_pdr(system), lied = check_pdr(system, options);
        EXPECT_EQ(lied.failures, std::vector<std::string>{}) << "a wrong result of the search is not an internal error";
        if (lied.fault) {
            ++faults;
            ASSERT_TRUE(honest.fault);
        }
        for (std::size_t i = 0; i < honest.verdicts.size(); ++i) {
            SCOPED_TRACE(honest.verdicts[i].property);
            doubted += lied.verdicts[i].obstacle == UnknownReason::Disagrees ? 1U : 0U;
            vacuous += honest.verdicts[i].vacuous ? 1U : 0U;
            if (lied.verdicts[i].obstacle == UnknownReason::Faulty) {
                ASSERT_EQ(honest.verdicts[i].obstacle, UnknownReason::Faulty);
            }
            if (lied.verdicts[i].outcome == Outcome::Unknown) continue;
            ++believed;
            ASSERT_EQ(lied.verdicts[i].outcome, honest.verdicts[i].outcome);
            ASSERT_EQ(lied.verdicts[i].vacuous, honest.verdicts[i].vacuous);
        }
    }
    std::cout << believed << " verdicts accepted, " << doubted << " rejected, " << vacuous << " vacuous, " << faults
              << " faults\n";
    EXPECT_GT(believed, 100u);
    EXPECT_GT(doubted, 100u);
    EXPECT_GT(vacuous, 0u);
    EXPECT_GT(faults, 0u);
}

TEST(RandomizedPdr, BoundsEndInUnknown) {
    const System system = untimed_sample("testing_station/testing_station.grafcet",
                                         {.plant = PlantApproach::Automata, .schedule = Schedule::Interleaved});
    const std::atomic<bool> stop = true;
    PdrOptions stopped;
    stopped.stop = &stop;
    PdrOptions late;
    late.deadline = std::chrono::steady_clock::now();

    for (const auto& [options, obstacle] :
         {std::pair(stopped, UnknownReason::Stopped), {late, UnknownReason::Stopped}}) {
        const PdrResult result = check_pdr(system, options);
        ASSERT_FALSE(result.verdicts.empty());
        for (const Verdict& verdict : result.verdicts)
            if (is_about_single_states(verdict.pattern)) {
                EXPECT_EQ(verdict.outcome, Outcome::Unknown);
                EXPECT_EQ(verdict.obstacle, obstacle);
            }
    }
}

}  // namespace
}  // namespace grafverif
