// SPDX-License-Identifier: MIT
// Compares searches with and without covering (src/check/timed/store/covering.hpp) on random networks and closed loops. The
// verdicts and the lengths of runs must be equal. If a model error is reachable, both searches find one. Each premise of
// the covering is omitted once, which must change a result.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <set>
#include <tuple>

#include "ir/patterns.hpp"
#include "support/random_loop.hpp"
#include "support/random_network.hpp"
#include "support/read_loop.hpp"
#include "support/test_size.hpp"
#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

constexpr std::uint64_t most_states = 100'000;

struct Seen {
    int compared = 0, smaller = 0, different = 0;
    std::uint64_t states = 0, stored = 0;
};

/// Keeps only the properties about single states, and adds a property about the reachability of each location.
void use_single_states(Network& network) {
    for (const Property& property : std::exchange(network.properties, {}))
        if (is_about_single_states(property.pattern)) network.properties.add(property);
    for (const Id<Network::Process> process : network.processes.ids())
        for (std::uint32_t k = 0; k < network.templates[network.processes[process].automaton].locations.size(); ++k)
            network.properties.add({.name = "at" + std::to_string(process.index) + "_" + std::to_string(k),
                                    .pattern = Pattern::Reachable,
                                    .operands = {network.exprs.at(process.index, k)}});
}

using Errors = std::set<std::tuple<ModelError::Kind, std::uint32_t, std::uint32_t, std::uint32_t>>;

Errors errors_of(const TimedResult& result) {
    Errors errors;
    for (const ModelError& error : result.errors)
        errors.emplace(error.kind, error.variable.index, error.process.index, error.edge.index);
    return errors;
}

/// True if both results contain the same verdicts, with runs of the same length. `one` may contain more model errors: a
/// search records one error per state, and an omitted state may have another error.
bool are_equal(const TimedResult& one, const TimedResult& other) {
    const auto length = [](const Verdict& verdict) { return verdict.run ? verdict.run->moves.size() : 0; };
    for (std::size_t i = 0; i < one.verdicts.size(); ++i) {
        const Verdict &a = one.verdicts[i], &b = other.verdicts[i];
        if (std::tie(a.property, a.outcome, a.vacuous, a.obstacle) !=
            std::tie(b.property, b.outcome, b.vacuous, b.obstacle))
            return false;
        if (length(a) != length(b)) return false;
    }
    const Errors errors = errors_of(one), found = errors_of(other);
    return errors.empty() == found.empty() && std::ranges::includes(errors, found) &&
           one.time_passes == other.time_passes;
}

TimedOptions options_of(bool covering, const CoveringAblations& without = {}) {
    return {.max_states = most_states, .timelock = false, .covering = covering, .covering_without = without};
}

/// Compares both searches, also with several threads and small blocks.
void compare(const Network& network, Seen& seen) {
    const TimedResult plain = check_timed(network, options_of(false));
    if (!plain.complete) return;
    const TimedResult covered = checked(network, options_of(true));
    ASSERT_EQ(plain.verdicts.size(), covered.verdicts.size());
    EXPECT_TRUE(covered.complete);
    EXPECT_TRUE(are_equal(plain, covered));
    EXPECT_LE(covered.states, plain.states);
    for (const unsigned jobs : {1U, 3U}) {
        TimedOptions options = options_of(true);
        options.jobs = jobs;
        options.slice = 1;
        const TimedResult other = check_timed(network, options);
        EXPECT_EQ(other.states, covered.states);
        EXPECT_EQ(other.transitions, covered.transitions);
        EXPECT_TRUE(are_equal(covered, other));
    }
    ++seen.compared;
    seen.smaller += covered.states < plain.states ? 1 : 0;
    seen.states += plain.states;
    seen.stored += covered.states;
}

Network network_of(std::uint64_t seed) {
    Random random(seed);
    Network network = random_network(random);
    use_single_states(network);
    return network;
}

void report(const char* name, const Seen& seen) {
    if (std::getenv("GRAFVERIF_TEST_COUNTS") == nullptr) return;
    std::printf("%s: %d compared, %d with fewer states; %llu states, %llu stored\n", name, seen.compared, seen.smaller,
                static_cast<unsigned long long>(seen.states), static_cast<unsigned long long>(seen.stored));
}

TEST(RandomizedCovering, RandomNetworksHaveTheSameVerdictsAndShortestRuns) {
    Seen seen;
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test_size(400)); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        compare(network_of(seed), seen);
        if (testing::Test::HasFailure()) break;
    }
    EXPECT_GT(seen.compared, test_size(200));
    EXPECT_GT(seen.smaller, test_size(50));
    report("networks", seen);
}

TEST(RandomizedCovering, RandomLoopsHaveTheSameVerdictsAndShortestRuns) {
    Seen seen;
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test_size(80)); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Model model = random_loop_asked(random, 6);
        if (seed % 4 == 0) add_task_cycles(model, random);
        try {
            Network network = composed_loop(model, {.grain = seed % 2 == 0 ? Grain::Atomic : Grain::Phased}).network;
            use_single_states(network);
            compare(network, seen);
        } catch (const std::invalid_argument&) {
            continue;  // compose rejects this loop
        }
        if (testing::Test::HasFailure()) break;
    }
    EXPECT_GT(seen.compared, test_size(80) / 4);
    EXPECT_GT(seen.smaller, test_size(80) / 8);
    report("loops", seen);
}

/// Returns the number of networks for which the search without a premise has another result.
int different(const std::vector<Network>& networks, const CoveringAblations& without) {
    int count = 0;
    for (const Network& network : networks) {
        const TimedResult plain = check_timed(network, options_of(false));
        EXPECT_TRUE(are_equal(plain, check_timed(network, options_of(true))));
        count += are_equal(plain, check_timed(network, options_of(true, without))) ? 0 : 1;
    }
    return count;
}

TEST(RandomizedCovering, LowerBoundsAreNeeded) {
    std::vector<Network> networks;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) networks.push_back(network_of(seed));
    EXPECT_GT(different(networks, {.lower = true}), 0);
}

TEST(RandomizedCovering, UpperBoundsAreNeeded) {
    // l1 is first reached with c0 == 3, and later with c0 == 0, which alone permits the edge to l4.
    Sketch sketch;
    const auto process = sketch.process("p", 5, 1);
    sketch.edge(process, {.from = 0, .to = 1, .when = {{0, Op::GreaterEqual, 3}}});
    sketch.edge(process, {.from = 0, .to = 2});
    sketch.edge(process, {.from = 2, .to = 3});
    sketch.edge(process, {.from = 3, .to = 1, .reset = {0}});
    sketch.edge(process, {.from = 1, .to = 4, .when = {{0, Op::LessEqual, 1}}});
    sketch.property("goal", Pattern::Reachable, {sketch.at(process, 4)});
    EXPECT_EQ(different({sketch.network}, {.upper = true}), 1);
}

TEST(RandomizedCovering, DepthIsNeeded) {
    // In one level, a delay reaches l2 with c0 == 2 and c1 == 2, and an edge reaches l2 with c0 == 0 and c1 == 2. The
    // second state simulates the first one. A delay from the first state continues the move that reached it; a delay
    // from the second state is a further move, so the run is longer.
    Sketch sketch;
    const auto process = sketch.process("p", 5, 2);
    sketch.invariant(process, 0, {1, Op::LessEqual, 1});
    sketch.invariant(process, 1, {1, Op::LessEqual, 2});
    sketch.edge(process, {.from = 0, .to = 1});
    sketch.edge(process, {.from = 0, .to = 2, .when = {{1, Op::GreaterEqual, 1}}});
    sketch.edge(process, {.from = 1, .to = 2, .when = {{1, Op::GreaterEqual, 2}}, .reset = {0}});
    sketch.edge(process, {.from = 2, .to = 3, .when = {{1, Op::GreaterEqual, 4}}});
    sketch.edge(process, {.from = 2, .to = 4, .when = {{0, Op::LessEqual, 5}}});
    sketch.property("goal", Pattern::Reachable, {sketch.at(process, 3)});
    EXPECT_EQ(different({sketch.network}, {.depth = true}), 1);
}

TEST(RandomizedCovering, IsNotUsedForPropertiesOfRuns) {
    Sketch sketch;
    const auto process = sketch.process("p", 2, 1);
    sketch.invariant(process, 0, {0, Op::LessEqual, 9});
    sketch.edge(process, {.from = 0, .to = 1});
    sketch.property("goal", Pattern::Reachable, {sketch.at(process, 1)});
    const std::uint64_t all = check_timed(sketch.network, options_of(false)).states;
    EXPECT_LT(check_timed(sketch.network, options_of(true)).states, all);
    sketch.property("moves", Pattern::Inevitable, {sketch.at(process, 1)});
    EXPECT_EQ(check_timed(sketch.network, options_of(true)).states, all);
}

}  // namespace
}  // namespace grafverif
