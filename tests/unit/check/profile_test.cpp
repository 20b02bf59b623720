// SPDX-License-Identifier: MIT
#include "check/timed/profile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "check/timed/explore.hpp"
#include "support/random_network.hpp"
#include "support/test_size.hpp"
#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

/// Adds a process that cycles through its locations at arbitrary times.
void wheel(Sketch& s, const std::string& name, std::uint32_t locations) {
    const auto process = s.process(name, locations);
    for (std::uint32_t at = 0; at < locations; ++at) s.edge(process, {.from = at, .to = (at + 1) % locations});
}

StateProfile profile_of(const Network& network) {
    const TimedResult result = check_timed(network, {.profile = ProfileFor::All});
    EXPECT_TRUE(result.profile);
    return result.profile.value_or(StateProfile{});
}

TEST(StateProfile, StatesTheFactorOfEachPart) {
    Sketch s;
    wheel(s, "small", 3);
    wheel(s, "large", 7);
    const StateProfile found = profile_of(s.network);
    ASSERT_EQ(found.parts.size(), 2U);
    EXPECT_EQ(found.states, found.sampled);
    EXPECT_EQ(found.parts[0].name, "large");
    EXPECT_EQ(found.parts[0].combinations, 7U);
    EXPECT_DOUBLE_EQ(found.parts[0].factor.value(), 7);
    EXPECT_EQ(found.parts[1].name, "small");
    EXPECT_DOUBLE_EQ(found.parts[1].factor.value(), 3);
}

TEST(StateProfile, GivesFactorOneToDeterminedParts) {
    Sketch s;
    const auto on = s.boolean("on"), lit = s.boolean("lit");
    const auto hand = s.process("hand", 1), bulb = s.process("bulb", 1);
    s.edge(hand, {.guard = s.op(Op::Equal, s.is(on), s.is(lit)), .set = {{on, s.no(s.is(on))}}});
    s.edge(hand, {.guard = s.no(s.is(on)), .set = {{lit, s.is(lit)}}});
    s.edge(bulb, {.guard = s.op(Op::NotEqual, s.is(on), s.is(lit)), .set = {{lit, s.is(on)}}});
    const StateProfile found = profile_of(s.network);
    EXPECT_EQ(found.states, 4U);
    ASSERT_EQ(found.parts[1].name, "bulb");
    EXPECT_DOUBLE_EQ(found.parts[1].factor.value(), 1) << "`lit` has two writers and belongs to no component";
    EXPECT_DOUBLE_EQ(found.parts[0].factor.value(), 2);
}

TEST(StateProfile, NamesTheLargestConstantOfEachClock) {
    Sketch s;
    const auto waiter = s.process("waiter", 2, 1);
    s.invariant(waiter, 0, {0, Op::LessEqual, 5});
    s.edge(waiter, {.from = 0, .to = 1, .when = {{0, Op::Equal, 5}}});
    const StateProfile found = profile_of(s.network);
    ASSERT_EQ(found.clocks.size(), 1U);
    EXPECT_EQ(found.clocks[0].process, "waiter");
    EXPECT_EQ(found.clocks[0].greatest, 5);
    EXPECT_EQ(found.clocks[0].values, 6U);
    EXPECT_EQ(found.inside_cycles, 0U);
}

TEST(StateProfile, IsComputedForLongAndStoppedSearches) {
    Sketch s;
    wheel(s, "one", 64);
    wheel(s, "two", 64);
    EXPECT_FALSE(check_timed(s.network).profile);
    const TimedResult cut = check_timed(s.network, {.max_states = 100});
    ASSERT_TRUE(cut.profile);
    EXPECT_EQ(cut.profile->states, cut.states);
}

TEST(StateProfile, OfManyStatesIsEqualByClassesAndReportsProgress) {
    Sketch s;
    wheel(s, "one", 128);
    wheel(s, "two", 128);
    wheel(s, "three", 65);
    std::size_t reported = 0;
    const TimedResult result = check_timed(s.network, {.keep_links = false, .many = [&](const StateProfile& profile) {
                                                           ++reported;
                                                           EXPECT_GE(profile.states, many_states);
                                                       }});
    EXPECT_EQ(reported, 1U);
    ASSERT_TRUE(result.profile);
    ASSERT_EQ(result.states, std::uint64_t{128} * 128 * 65);
    ASSERT_EQ(result.profile->sampled, result.states) << "all states are sampled";
    for (const StateProfile::Component& part : result.profile->parts) {
        EXPECT_LT(part.factor.states, result.states) << "the factor is computed from some of the states";
        EXPECT_DOUBLE_EQ(part.factor.value(), part.name == "three" ? 65 : 128);
    }
}

// The following test computes the numbers of a profile independently, from sets of complete states.

using Values = std::vector<std::int64_t>;

struct Place {
    timed::Field field = {};
    std::string part = {};
    std::string clock = {};
};

std::vector<Place> places_of(const Network& network, const timed::Layout& layout) {
    std::vector<Place> places;
    std::map<std::size_t, std::set<std::string>> writers;
    for (const Id<Network::Process> id : network.processes.ids()) {
        const Network::Process& process = network.processes[id];
        const Network::Template& automaton = network.templates[process.automaton];
        places.push_back({layout.locations[id.index], process.name, ""});
        for (const Id<Network::Clock> clock : automaton.clocks.ids())
            places.push_back({layout.clocks[id.index][clock.index], process.name,
                              process.name + "." + automaton.clocks[clock].name});
        const auto write = [&](const std::vector<Network::Assignment>& assignments) {
            for (const Network::Assignment& each : assignments)
                writers[static_cast<std::size_t>(network.exprs[each.target].value)].insert(process.name);
        };
        for (const Network::Edge& edge : automaton.edges) write(edge.assignments);
        for (const Network::Procedure& procedure : automaton.procedures) write(procedure.assignments);
    }
    for (const Id<Network::Variable> id : network.variables.ids()) {
        if (network.variables[id].scratch) continue;
        const std::set<std::string>& by = writers[id.index];
        places.push_back({layout.variables[id.index], by.size() == 1 ? *by.begin() : "", ""});
    }
    return places;
}

/// Returns the number of distinct states, restricted to the `places` that `counts` selects.
template <class Counts>
std::uint64_t different(const std::vector<Values>& states, const std::vector<Place>& places, const Counts& counts) {
    std::set<Values> kept;
    for (const Values& state : states) {
        Values rest;
        for (std::size_t i = 0; i < places.size(); ++i)
            if (counts(places[i])) rest.push_back(state[i]);
        kept.insert(std::move(rest));
    }
    return kept.size();
}

TEST(RandomizedStateProfile, AgreesWithSetsOfCompleteStates) {
    Random random(41);
    const int cases = test_size(60);
    std::size_t compared = 0;
    for (int i = 0; i < cases; ++i) {
        const Network network = expand(random_network(random));
        timed::Machine machine(network);
        timed::PropertyMonitor watch;
        const TimedOptions options{.max_states = 2'000};
        timed::Limits limits(options);
        timed::Graph graph(machine);
        timed::explore(graph, watch, {}, limits);
        constexpr std::int64_t ratio = 3;
        const StateProfile found = timed::profile_of(graph, StateProfile::Finest{.unit_ms = 1, .coarser_ms = ratio});
        const std::vector<Place> places = places_of(network, machine.layout());
        std::vector<Values> states;
        for (std::uint32_t state = 0; state < graph.states(); ++state) {
            Values values;
            for (const Place& place : places) values.push_back(place.field.get(graph.load(state)));
            states.push_back(std::move(values));
        }
        for (const StateProfile::Component& part : found.parts) {
            EXPECT_EQ(part.combinations,
                      different(states, places, [&](const Place& at) { return at.part == part.name; }));
            EXPECT_EQ(part.factor.merged,
                      different(states, places, [&](const Place& at) { return at.part != part.name; }));
            EXPECT_EQ(part.factor.states, states.size());
            ++compared;
        }
        std::set<Values> coarse;
        for (Values values : states) {
            for (std::size_t at = 0; at < places.size(); ++at)
                if (!places[at].clock.empty()) values[at] /= ratio;
            coarse.insert(std::move(values));
        }
        ASSERT_TRUE(found.finest);
        EXPECT_EQ(found.finest->factor.merged, coarse.size());
        EXPECT_EQ(found.finest->factor.states, states.size());
        for (const StateProfile::Clock& clock : found.clocks) {
            const std::string name = clock.process + "." + clock.name;
            EXPECT_EQ(clock.factor.merged,
                      different(states, places, [&](const Place& at) { return at.clock != name; }));
            ++compared;
        }
    }
    EXPECT_GT(compared, static_cast<std::size_t>(cases));
}

TEST(StateProfile, IsComputedForTheSelectedSearches) {
    Sketch s;
    wheel(s, "small", 3);
    wheel(s, "large", 7);
    const auto has_profile = [&](ProfileFor profile, std::uint64_t max_states) {
        return check_timed(s.network, {.max_states = max_states, .profile = profile}).profile.has_value();
    };
    EXPECT_TRUE(has_profile(ProfileFor::All, 100));
    EXPECT_FALSE(has_profile(ProfileFor::IfLarge, 100));
    EXPECT_TRUE(has_profile(ProfileFor::IfLarge, 10)) << "the limit ended the search";
    EXPECT_FALSE(has_profile(ProfileFor::None, 10));
}

}  // namespace
}  // namespace grafverif
