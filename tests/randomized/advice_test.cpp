// SPDX-License-Identifier: MIT
// Randomized tests of the advice in reports about invariants that block time and about steps that are never active. The
// expected results are computed with the network simulator.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "check/timed/timed.hpp"
#include "explain/dead_steps.hpp"
#include "explain/standstill.hpp"
#include "grafverif/grafverif.hpp"
#include "ir/network_run.hpp"
#include "pipeline/check.hpp"
#include "pipeline/models.hpp"
#include "support/random_loop.hpp"
#include "support/random_network.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

/// Returns the network without the invariants of the locations in `blockers`. In this network, the process of each
/// blocker may stay in the location of the blocker arbitrarily long; all other invariants are unchanged.
Network without_bounds(const Network& network, const std::vector<Standstill::Blocker>& blockers) {
    Network relaxed = expand(network);
    for (const Standstill::Blocker& each : blockers)
        relaxed.templates[relaxed.processes[each.process].automaton].locations[each.location].invariant.clear();
    return relaxed;
}

/// True if edges lead from `state` to a state in which time passes, or to a model error.
bool time_may_pass_again(const Network& network, const NetworkState& state) {
    std::vector<NetworkState> found = {state};
    for (std::size_t k = 0; k < found.size(); ++k) {
        if (may_delay(network, found[k])) return true;
        for (const Fire& move : enabled(network, found[k])) {
            NetworkState next = found[k];
            if (perform(network, next, move).result != Step::Result::Done) return true;
            if (std::ranges::find(found, next) == found.end()) found.push_back(std::move(next));
        }
    }
    return false;
}

TEST(RandomizedAdvice, NamedInvariantsAndNoOthersBlockTimeAtTheEnd) {
    int blocked = 0, several = 0, repeating = 0;
    for (int seed = 1; seed <= test_size(3000); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Network network = random_network(random);
        TimedOptions options;
        options.max_states = 2000;
        const TimedResult result = check_timed(network, options);
        for (const Verdict& verdict : result.verdicts) {
            if (verdict.pattern != Pattern::NoTimelock || verdict.outcome != Outcome::Violated) continue;
            const Standstill found = standstill(network, verdict.run.value());
            const std::string words = standstill_words(network, found);
            const auto states = replay(network, *verdict.run);
            ASSERT_TRUE(states);
            EXPECT_FALSE(time_may_pass_again(network, states->back()));
            if (result.errors.empty()) {
                EXPECT_NE(words, "");
                EXPECT_FALSE(found.continued);
            }
            if (found.continued) continue;
            if (!found.repeating.empty()) {
                ASSERT_TRUE(verdict.run->loop);
                for (std::size_t k = *verdict.run->loop; k < states->size(); ++k)
                    EXPECT_FALSE(may_delay(network, (*states)[k]));
                ++repeating;
            }
            // Checks that time can pass without the named invariants, but not if one of them is kept.
            const NetworkState& end = states->back();
            if (found.repeating.empty() && !found.blockers.empty()) {
                EXPECT_TRUE(may_delay(without_bounds(network, found.blockers), end)) << words;
                ++blocked;
            }
            for (std::size_t k = 0; k < found.blockers.size(); ++k) {
                std::vector<Standstill::Blocker> others = found.blockers;
                others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
                EXPECT_FALSE(may_delay(without_bounds(network, others), end)) << words;
                EXPECT_NE(words.find('`' + network.processes[found.blockers[k].process].name + "` blocks time"),
                          std::string::npos)
                    << words;
            }
            several += found.blockers.size() > 1 ? 1 : 0;
        }
    }
    EXPECT_GT(blocked, 20);
    EXPECT_GT(several, 0);
    EXPECT_GT(repeating, 0);
}

/// All reachable states in integer time; `all` is empty if there are too many. A firing condition keeps its value after
/// the edge of its controller, so that the states show the cleared transitions.
struct States {
    std::vector<NetworkState> all = {};
    std::set<std::uint32_t> cleared = {};  ///< the variables of firing conditions that were true
};

States states_of(const Network& network, std::size_t most) {
    constexpr std::int64_t cap = 40;  // larger than all clock bounds of random loops
    States found;
    std::set<std::pair<std::vector<std::uint32_t>, std::vector<std::int64_t>>> seen;
    const auto add = [&](NetworkState state) {
        std::vector<std::uint32_t> locations;
        std::vector<std::int64_t> values;
        for (const Id<Network::Location> location : state.locations) locations.push_back(location.index);
        for (const Id<Network::Variable> id : network.variables.ids())
            if (!network.variables[id].scratch) values.push_back(state.variables[id.index]);
        for (std::vector<std::int64_t>& clocks : state.clocks)
            for (std::int64_t& clock : clocks) values.push_back(clock = std::min(clock, cap));
        if (seen.emplace(std::move(locations), std::move(values)).second) found.all.push_back(std::move(state));
    };
    add(initial_state(network));
    for (std::size_t k = 0; k < found.all.size(); ++k) {
        if (found.all.size() > most) return {};
        NetworkState later = found.all[k];
        if (perform(network, later, Delay{1}).result == Step::Result::Done) add(later);
        for (const Fire& fire : enabled(network, found.all[k])) {
            NetworkState next = found.all[k];
            if (perform(network, next, fire).result != Step::Result::Done) continue;
            for (const Network::Controller& controller : network.controllers)
                if (controller.process == fire.process)
                    for (const auto& transition : controller.words.transitions)
                        if (next.variables[transition.variable.index] != 0)
                            found.cleared.insert(transition.variable.index);
            add(std::move(next));
        }
    }
    return found;
}

/// Returns the number of statements about dead transitions in the report. Each statement must be true in all `states`.
int statements_checked(const Report& report, Network network, const std::vector<const Chart*>& charts,
                       const States& states) {
    int checked = 0;
    std::set<std::string> notes;
    for (const PropertyResult& answer : report.answers)
        for (const std::string& note : answer.verdict.notes)
            if (note.find("` is never ") != std::string::npos) notes.insert(note);
    for (std::size_t k = 0; k < charts.size(); ++k) {
        const auto& words = network.controllers[{static_cast<std::uint32_t>(k)}].words;
        const std::string prefix = charts.size() > 1 ? words.name + ": " : "";
        for (const Id<Chart::Step> step : charts[k]->steps.ids())
            for (const DeadTransition& each :
                 dead_transitions(*charts[k], condition_leaves(words), step, network.exprs)) {
                if (!notes.contains(prefix + each.words)) continue;
                ++checked;
                EXPECT_FALSE(states.cleared.contains(words.transitions[each.transition.index].variable.index))
                    << each.words;
                EXPECT_TRUE(std::ranges::all_of(states.all, [&](const NetworkState& state) {
                    return value(network, state, each.never) == 0;
                })) << each.words;
            }
    }
    return checked;
}

TEST(RandomizedAdvice, NamedTransitionsAreNeverClearedAndNamedTermsAreNeverTrue) {
    int timed = 0, untimed = 0, discrete = 0;
    for (int seed = 1; seed <= test_size(30); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        Model model = random_loop(random);
        ClosedLoop& loop = model.loops[{0}];
        loop.properties = {};
        loop.properties.add({.name = "steps", .pattern = Pattern::ReachableAllSteps});
        ModelOptions how;
        how.grain = seed % 2 == 0 ? Grain::Atomic : Grain::Phased;
        Diagnostics diagnostics;
        const auto network = network_of(model, {0}, how, diagnostics);
        if (!network) continue;
        const States states = states_of(*network, 500);
        if (states.all.empty()) continue;
        const std::vector<const Chart*> charts = charts_of(model, loop);
        CheckOptions options;
        options.jobs = 1;
        options.limits.states = 20'000;
        options.limits.memory = std::uint64_t{2} << 20U;
        if (const auto report = check(model, {0}, how, options, diagnostics))
            timed += statements_checked(*report, *network, charts, states);
        if (states.all.size() > 150) continue;  // the symbolic engine may need seconds for more states
        how.untimed.plant = PlantApproach::Automata;
        for (const TimeModel time : {TimeModel::Abstract, TimeModel::Discrete}) {
            how.untimed.time = time;
            const auto system = transition_system_of(model, Id<ClosedLoop>{0}, how, diagnostics);
            if (!system) continue;
            const Report report = check(system_to_check(*system, model, {0}, how), options);
            (time == TimeModel::Abstract ? untimed : discrete) += statements_checked(report, *network, charts, states);
        }
    }
    EXPECT_GT(timed, 0);
    EXPECT_GT(untimed, 0);
    EXPECT_GT(discrete, 0);
}

}  // namespace
}  // namespace grafverif
