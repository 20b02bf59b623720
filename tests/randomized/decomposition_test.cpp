// SPDX-License-Identifier: MIT
// Compares compositional checking with checking the complete network, on random networks of two to four independent
// subsystems (parts). Each premise is omitted once, to show that the comparison detects the omission.
#include "check/decomposition/decomposition.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "check/decomposition/preservation.hpp"
#include "ir/network_run.hpp"
#include "ir/network_subsystems.hpp"
#include "pipeline/check.hpp"
#include "run/project.hpp"
#include "run/replay.hpp"
#include "support/random_subsystems.hpp"
#include "support/read_loop.hpp"
#include "support/row_counts.hpp"
#include "support/test_size.hpp"
#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

constexpr std::uint64_t complete_limit = 20'000;

/// True if some part of the network can never take an edge again from `state` on, after any delay.
bool some_part_is_dead(const Network& network, NetworkState state) {
    const NetworkSubsystems parts = parts_of(network);
    std::set<std::uint32_t> dead;
    for (std::uint32_t part = 0; part < parts.count; ++part) {
        SubNetworkBuilder builder(network, parts, {part});
        const SubNetwork sub = std::move(builder).build();
        NetworkState here;
        for (const Id<Network::Variable> id : sub.variables) here.variables.push_back(state.variables[id.index]);
        for (const Id<Network::Process> id : sub.processes) {
            here.locations.push_back(state.locations[id.index]);
            here.clocks.push_back(state.clocks[id.index]);
        }
        bool moves = false;
        for (int units = 0; units < 10 && !moves; ++units) {
            moves = !enabled(sub.network, here).empty();
            if (perform(sub.network, here, Delay{1}).result != Step::Result::Done) break;
        }
        if (!moves) dead.insert(part);
    }
    return !dead.empty();
}

void confirm_run(const Network& network, const Property& property, const Verdict& verdict) {
    if (property.pattern != Pattern::NoDeadlock || property.at_stable) return confirm(network, property, verdict);
    const auto states = replay(network, *verdict.run);
    ASSERT_TRUE(states) << "the run fails the replay";
    EXPECT_TRUE(some_part_is_dead(network, states->back()));
}

std::string claim(const Property& property, Outcome outcome) {
    return std::to_string(static_cast<int>(property.pattern)) + (property.at_stable ? " at stable " : " ") +
           std::string(word(outcome));
}

/// Compares the verdicts of the two methods on one property.
void compare(const Network& network, const Property& property, const Verdict& apart, const Verdict& whole,
             std::map<std::string, int>& seen) {
    SCOPED_TRACE(property.name + ", pattern " + std::to_string(static_cast<int>(property.pattern)) +
                 (property.at_stable ? " at stable" : "") + ": by parts " + std::string(word(apart.outcome)) + " (" +
                 apart.reason + "), complete network " + std::string(word(whole.outcome)) + " (" + whole.reason + ")");
    const bool checked_separately = !apart.scope.searched.empty();
    ++seen[claim(property, apart.outcome) + (checked_separately ? ", apart" : ", whole")];
    if (apart.run) confirm_run(network, property, apart);
    // `no deadlock` of every part implies `no deadlock` of the complete network.
    if (property.pattern == Pattern::NoDeadlock && !property.at_stable) {
        EXPECT_FALSE(apart.outcome == Outcome::Holds && whole.outcome == Outcome::Violated);
        return;
    }
    if (whole.outcome != Outcome::Unknown) {
        EXPECT_EQ(apart.outcome, whole.outcome);
        EXPECT_EQ(apart.vacuous, whole.vacuous);
    }
    if (whole.outcome != Outcome::Unknown) {
        EXPECT_EQ(apart.run.has_value(), whole.run.has_value());
    }
    if (whole.outcome == Outcome::Unknown && apart.outcome != Outcome::Unknown &&
        whole.obstacle == UnknownReason::Faulty) {
        const bool reachable = property.pattern == Pattern::Reachable || property.pattern == Pattern::ReachableAllSteps;
        EXPECT_EQ(apart.outcome, reachable ? Outcome::Violated : Outcome::Holds)
            << "an error can only remove states, so only this verdict is valid";
    }
}

/// Checks compositional verdicts on properties for which the verdict of the complete network is inexact. With a finer
/// time unit, the verdict of the complete network must be the same or unknown.
void compare_finer(const Network& network, const TimedResult& apart, const TimedResult& whole) {
    for (const std::int64_t factor : {2, 3}) {
        std::optional<TimedResult> finer;
        for (const Verdict& given : apart.verdicts) {
            const Verdict& open = verdict(whole, given.property);
            if (given.outcome == Outcome::Unknown || open.obstacle != UnknownReason::Inexact) continue;
            if (given.pattern == Pattern::NoDeadlock) continue;
            if (!finer) finer = check_timed(refined(network, factor), {.max_states = complete_limit});
            const Verdict& found = verdict(*finer, given.property);
            EXPECT_TRUE(found.outcome == Outcome::Unknown || found.outcome == given.outcome)
                << given.property << " with a finer time unit";
        }
    }
}

using Place = std::tuple<ModelError::Kind, std::uint32_t, std::uint32_t, std::uint32_t>;

std::set<Place> places(const Network& network, const std::vector<ModelError>& errors) {
    std::set<Place> all;
    for (const ModelError& error : errors) {
        EXPECT_TRUE(replay(network, error.run)) << "the run to an error fails the replay";
        all.emplace(error.kind, error.variable.index, error.process.index, error.edge.index);
    }
    return all;
}

/// Checks the network by both methods. Returns nothing if the complete network is too large.
std::optional<TimedResult> compared(const Network& network, std::map<std::string, int>& seen) {
    const TimedResult whole = check_timed(network, {.max_states = complete_limit});
    if (!whole.complete) return {};
    const TimedResult apart = check_timed_by_parts(network, {.max_states = complete_limit});
    EXPECT_EQ(apart.verdicts.size(), whole.verdicts.size());
    for (std::size_t i = 0; i < std::min(apart.verdicts.size(), whole.verdicts.size()); ++i) {
        EXPECT_EQ(apart.verdicts[i].property, whole.verdicts[i].property);
        EXPECT_EQ(apart.verdicts[i].about, whole.verdicts[i].about);
        if (const Id<Property> about = apart.verdicts[i].about; about.valid())
            compare(network, network.properties[about], apart.verdicts[i], whole.verdicts[i], seen);
    }
    EXPECT_EQ(apart.time_passes, whole.time_passes);
    EXPECT_EQ(places(network, apart.errors), places(network, whole.errors));
    compare_finer(network, apart, whole);
    ++seen["networks compared"];
    return apart;
}

TEST(RandomizedDecomposition, CompositionalChecksGiveTheVerdictsAndRunsOfTheCompleteModel) {
    std::map<std::string, int> seen;
    const auto networks = static_cast<std::uint64_t>(test_size(200));
    for (std::uint64_t seed = 1; seed <= networks && !testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Network network = random_parts(random, static_cast<int>(random_number(random, 2, 4)));
        query_subsystems(network, random);
        ASSERT_EQ(verify(network), std::vector<std::string>{});
        compared(network, seen);
    }
    EXPECT_GT(seen["networks compared"], test_size(200) / 2);
    print_counts(seen);
}

TEST(RandomizedDecomposition, RunsOfCompositionalChecksReplayOnAllCharts) {
    std::map<std::string, int> seen;
    const auto loops = static_cast<std::uint64_t>(test_size(15));
    for (std::uint64_t seed = 1; seed <= loops && !testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        LoopUnderTest loop;
        try {
            loop = read_loop(loop_of_plcs(random, static_cast<int>(random_number(random, 2, 3))),
                             {.grain = seed % 2 == 0 ? Grain::Atomic : Grain::Phased});
        } catch (const std::invalid_argument& refused) {
            ADD_FAILURE() << refused.what();
            continue;
        }
        EXPECT_GE(parts_of(loop.network).count, 2U);
        const auto apart = compared(expand(loop.network), seen);
        if (!apart) continue;
        const auto replays = [&](const grafverif::Run& run) {
            const auto wrong = disagreement(project(loop.network, run), loop.charts());
            EXPECT_FALSE(wrong) << replay_failure("a run", *wrong);
            ++seen["runs replayed"];
        };
        for (const Verdict& given : apart->verdicts)
            if (given.run) replays(*given.run);
        for (const ModelError& error : apart->errors) replays(error.run);
    }
    EXPECT_GT(seen["runs replayed"], test_size(15));
    print_counts(seen);
}

/// A part of a network: the verdicts on the properties that read only this part, and the premises that the part fulfils
/// if it is omitted.
struct Alone {
    TimedResult result = {};
    OmittedSubsystem as = {};
};

Alone alone(const Network& network, const NetworkSubsystems& parts, std::uint32_t part) {
    SubNetworkBuilder builder(network, parts, {part});
    for (const Property& property : network.properties)
        if (parts_read(network, parts, property.operands) == std::vector{part}) builder.add_property(property);
    builder.add_property({.name = "no timelock", .pattern = Pattern::NoTimelock});
    Alone made;
    made.result = check_timed(std::move(builder).build().network, {.premises = true});
    const Premises& premises = made.result.premises.value();
    made.as = {.name = "part " + std::to_string(part),
               .searched = true,
               .faulty = !made.result.errors.empty(),
               .diverges = premises.diverges.has_value(),
               .never_locks = verdict(made.result, "no timelock").outcome == Outcome::Holds,
               .rests = premises.rests,
               .settles = premises.settles,
               .time_passes = made.result.time_passes};
    return made;
}

/// A premise that the test omits: it is assumed to hold for every omitted subsystem.
struct Premise {
    const char* name = "";
    void (*grant)(OmittedSubsystem&) = nullptr;
};
const Premise premises[] = {
    {"the others can let time pass forever", [](OmittedSubsystem& other) { other.diverges = true; }},
    {"the others have no timelock", [](OmittedSubsystem& other) { other.never_locks = true; }},
    {"the others become quiescent in every instant", [](OmittedSubsystem& other) { other.rests = true; }},
    {"the others are quiescent when time passes", [](OmittedSubsystem& other) { other.settles = true; }},
    {"the others have no model errors", [](OmittedSubsystem& other) { other.faulty = false; }},
};

/// Compares the verdict of each part with that of the complete network. For each premise, counts in `tried` the verdicts
/// that are preserved if only this premise is assumed without a check, and in `failed` those that are wrong.
void leave_out(const Network& network, const TimedResult& whole, std::map<std::string, int>& tried,
               std::map<std::string, int>& failed) {
    const NetworkSubsystems parts = parts_of(network);
    std::vector<Alone> each;
    for (std::uint32_t part = 0; part < parts.count; ++part) each.push_back(alone(network, parts, part));
    for (const Property& property : network.properties) {
        const std::vector<std::uint32_t> read = parts_read(network, parts, property.operands);
        if (read.size() != 1) continue;
        const Verdict& here = verdict(each[read.front()].result, property.name);
        const Verdict& there = verdict(whole, property.name);
        if (here.outcome == Outcome::Unknown || there.outcome == Outcome::Unknown) continue;
        const bool differs = here.outcome != there.outcome;
        const auto objections = [&](const Premise* granted) {
            std::vector<OmittedSubsystem> others;
            for (std::uint32_t part = 0; part < parts.count; ++part)
                if (part != read.front()) others.push_back(each[part].as);
            std::vector<const OmittedSubsystem*> all;
            for (OmittedSubsystem& other : others) {
                if (granted != nullptr) granted->grant(other);
                all.push_back(&other);
            }
            return preservation_obstacle(here, property.at_stable, all);
        };
        const bool apart = !property.at_stable || settled_separately(property.pattern);
        const bool stands = objections(nullptr).empty();
        EXPECT_FALSE(stands && apart && differs) << property.name;
        if (stands && !apart && ++tried["quiescence at the end"] != 0 && differs) ++failed["quiescence at the end"];
        if (stands || !apart) continue;
        for (const Premise& premise : premises) {
            if (!objections(&premise).empty()) continue;
            ++tried[premise.name];
            if (differs) ++failed[premise.name];
        }
    }
}

TEST(RandomizedDecomposition, EachPremiseIsNeeded) {
    std::map<std::string, int> tried, failed;
    const auto networks = static_cast<std::uint64_t>(test_size(1000));
    for (std::uint64_t seed = 1; seed <= networks && !testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(1'000'000 + seed);
        Network network = random_parts(random, 2);
        query_subsystems(network, random);
        const TimedResult whole = check_timed(network, {.max_states = complete_limit});
        if (whole.complete) leave_out(network, whole, tried, failed);
    }
    std::map<std::string, int> counts;
    for (const auto& [what, count] : tried) {
        counts[what + ": omitted"] = count;
        counts[what + ": wrong verdicts"] = failed[what];
        // Without the second premise, 12 of 5,019 verdicts were wrong in 30,000 networks; a small number of networks
        // may show none.
        const bool rare = what == premises[1].name && count < 3000;
        EXPECT_TRUE(failed[what] > 0 || rare || what == premises[4].name) << what;
    }
    EXPECT_EQ(tried.size(), 6U);
    print_counts(counts);
}

}  // namespace
}  // namespace grafverif
