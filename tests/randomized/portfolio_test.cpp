// SPDX-License-Identifier: MIT
// Compares the portfolio engine with the symbolic engine alone, on random systems and on random loops in every approach
// and schedule. Faults, verdicts, vacuity and the lengths of shortest runs must be equal, in any order of the engines.
#include "check/portfolio.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "pipeline/check.hpp"
#include "run/project.hpp"
#include "run/replay.hpp"
#include "support/random_loop.hpp"
#include "support/random_system.hpp"
#include "support/test_size.hpp"
#include "support/untimed_loop.hpp"

namespace grafverif {
namespace {

using System = TransitionSystem;

struct Compared {
    std::size_t systems = 0, runs = 0, faults = 0, given_up = 0, alone = 0;
    std::map<std::string, std::size_t> by = {};  ///< number of verdicts for each engine named in their notes
};

bool gave_up(const std::vector<Verdict>& verdicts) {
    return std::ranges::any_of(verdicts,
                               [](const Verdict& verdict) { return verdict.obstacle == UnknownReason::Stopped; });
}

std::string decided_by(const Verdict& verdict) {
    const auto found =
        std::ranges::find_if(verdict.notes, [](const std::string& note) { return note.starts_with("decided by "); });
    return found == verdict.notes.end() ? "" : *found;
}

bool is_shortest(const Verdict& verdict) {
    return decided_by(verdict) != "decided by pdr" ||
           std::ranges::find(verdict.notes, "no shorter trace exists") != verdict.notes.end();
}

void compare_verdict(const Verdict& verdict, const std::optional<SystemRun>& run, const Verdict& expected,
                     const std::optional<SystemRun>& expected_run, bool alone, Compared& compared) {
    SCOPED_TRACE(expected.property + ", " + decided_by(verdict));
    ASSERT_EQ(verdict.property, expected.property);
    ASSERT_EQ(verdict.outcome, expected.outcome) << verdict.reason;
    ASSERT_EQ(verdict.vacuous, expected.vacuous);
    ASSERT_EQ(run.has_value(), expected_run.has_value());
    if (verdict.outcome == Outcome::Unknown) return;
    ASSERT_EQ(decided_by(verdict).empty(), alone);
    ++compared.by[decided_by(verdict)];
    const bool lasso = run && run->loop;
    if (!run || lasso || !is_shortest(verdict)) return;
    EXPECT_EQ(run->states.size(), expected_run->states.size());
    ++compared.runs;
}

/// Compares both engines on `system`; skips a system with a dead end, which only one of the engines detects.
std::optional<PdrResult> compare(const System& system, Compared& compared, const PortfolioOptions& how = {}) {
    constexpr std::chrono::milliseconds time_limit(300);
    const SymbolicResult alone = check_symbolic(system, {.deadline = std::chrono::steady_clock::now() + time_limit});
    if (gave_up(alone.verdicts)) {
        ++compared.given_up;
        return {};
    }
    if (alone.fault && alone.fault->kind == SystemFault::Kind::DeadEnd) return {};
    PortfolioResult all = check_together(system, how);
    EXPECT_EQ(all.failures, std::vector<std::string>{});
    EXPECT_EQ(all.fault.has_value(), alone.fault.has_value());
    ++compared.systems;
    if (alone.fault) {
        ++compared.faults;
        EXPECT_TRUE(!all.fault || all.fault->kind == alone.fault->kind);
        return all;
    }
    EXPECT_EQ(all.verdicts.size(), alone.verdicts.size());
    for (std::size_t i = 0; i < alone.verdicts.size() && !testing::Test::HasFatalFailure(); ++i)
        compare_verdict(all.verdicts[i], all.runs[i], alone.verdicts[i], alone.runs[i], all.alone, compared);
    compared.alone += all.alone ? 1 : 0;
    return all;
}

void say(const Compared& compared) {
    std::cout << compared.systems << " systems, " << compared.faults << " faults, " << compared.runs
              << " shortest runs";
    for (const auto& [who, verdicts] : compared.by) std::cout << ", " << verdicts << ' ' << who;
    std::cout << ", " << compared.given_up << " given up\n";
}

TEST(RandomizedPortfolio, AgreesWithTheSymbolicEngineAloneOnRandomSystems) {
    Compared compared;
    for (int seed = 1; seed <= test_size(300) && !HasFatalFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        System system = random_system(random);
        ask_more(system, random);
        compare(system, compared);
    }
    say(compared);
    EXPECT_GT(compared.faults, 0u);
    EXPECT_GT(compared.runs, 100u);
}

/// Tests the portfolio without threads, with engines that join at any time, and with PDR alone.
TEST(RandomizedPortfolio, VerdictsDoNotDependOnTheOrderOfEngines) {
    Compared compared;
    std::size_t by_pdr = 0;
    for (int seed = 1; seed <= test_size(100) && !HasFatalFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(1000 + seed));
        System system = random_system(random);
        ask_more(system, random);
        const auto joining = static_cast<std::uint64_t>(random_number(random, 0, 20'000));
        for (const auto& [alone, jobs] : {std::pair<std::uint64_t, unsigned>{0, 1}, {1, 1}, {joining, 2}, {~0ULL, 2}}) {
            PortfolioOptions how;
            how.alone = alone;
            how.jobs = jobs;
            const auto found = compare(system, compared, how);
            if (!found || found->fault || alone != 0) continue;
            const PdrResult pdr =
                check_pdr(system, {.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(1)});
            for (std::size_t i = 0; i < pdr.verdicts.size(); ++i) {
                if (pdr.verdicts[i].outcome == Outcome::Unknown) continue;
                EXPECT_EQ(pdr.verdicts[i].outcome, found->verdicts[i].outcome) << pdr.verdicts[i].property;
                ++by_pdr;
            }
        }
    }
    say(compared);
    EXPECT_GT(compared.alone, 0u);
    EXPECT_GT(by_pdr, 100u);
}

TEST(RandomizedPortfolio, AgreesWithTheSymbolicEngineAloneOnRandomLoopsAndItsRunsReplay) {
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
            const auto result = compare(system, compared);
            ASSERT_FALSE(HasFatalFailure());
            for (std::size_t i = 0; result && i < result->runs.size(); ++i) {
                if (!result->runs[i]) continue;
                const auto found = disagreement(project(system, *result->runs[i]), charts);
                ASSERT_FALSE(found) << "step " << found->move << ", " << found->where << ": " << found->what;
                ++replayed;
            }
        }
    }
    say(compared);
    EXPECT_GT(replayed, 0u);
}

TEST(RandomizedPortfolio, BoundsEndInUnknown) {
    const System system = untimed_sample("testing_station/faulty.grafcet",
                                         {.plant = PlantApproach::Automata, .time = TimeModel::Discrete});
    const std::atomic<bool> stop = true;
    PortfolioOptions stopped, late, small;
    stopped.stop = &stop;
    late.deadline = std::chrono::steady_clock::now();
    small.max_memory = std::uint64_t{1} << 20U;
    for (const auto& [options, obstacle] :
         {std::pair(stopped, UnknownReason::Stopped), {late, UnknownReason::Stopped}, {small, UnknownReason::Memory}}) {
        const PortfolioResult result = check_together(system, options);
        ASSERT_FALSE(result.verdicts.empty());
        EXPECT_EQ(result.failures, std::vector<std::string>{});
        for (const Verdict& verdict : result.verdicts)
            if (verdict.obstacle != UnknownReason::Unsupported) {
                EXPECT_EQ(verdict.outcome, Outcome::Unknown);
                EXPECT_EQ(verdict.obstacle, obstacle) << verdict.reason;
            }
    }
}

TEST(RandomizedPortfolio, CancellationAtAnyTimeReturnsTheResultsSoFar) {
    const System system = untimed_sample("pick_and_place/pick_and_place.grafcet", {});
    const PortfolioResult whole = check_together(system, {});
    for (std::size_t calls = 1; calls <= 8; calls *= 2) {
        std::atomic<bool> stop = false;
        std::size_t reported = 0;
        PortfolioOptions options;
        options.stop = &stop;
        options.progress = [&](const PortfolioProgress&) { stop = ++reported >= calls; };
        const PortfolioResult part = check_together(system, options);
        ASSERT_EQ(part.verdicts.size(), whole.verdicts.size());
        for (std::size_t i = 0; i < part.verdicts.size(); ++i)
            if (part.verdicts[i].outcome != Outcome::Unknown) {
                EXPECT_EQ(part.verdicts[i].outcome, whole.verdicts[i].outcome);
            }
    }
}

}  // namespace
}  // namespace grafverif
