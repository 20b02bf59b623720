// SPDX-License-Identifier: MIT
// Randomized test: a closed loop with discrete time in a transition system has the states and verdicts of the timed
// engine.
#include <gtest/gtest.h>

#include <iostream>

#include "check/symbolic/symbolic.hpp"
#include "check/timed/timed.hpp"
#include "compose/compose.hpp"
#include "plant/plant.hpp"
#include "schedule/network.hpp"
#include "support/derived.hpp"
#include "support/random_loop.hpp"
#include "support/read_loop.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

struct Tally {
    std::uint64_t states = 0;
    std::size_t verdicts = 0, loops = 0, left_out = 0;
};

/// Networks with more clocks are not compared, because decision diagrams of many independent clocks are too large.
constexpr std::size_t most_clocks = 6;

std::size_t clock_count(const Network& network) {
    std::size_t count = 0;
    for (const Network::Process& process : network.processes)
        count += network.templates[process.automaton].clocks.size();
    return count;
}

/// Compares the two engines on `network` unless it has more than `limit` states or a model error.
void compare(const Model& model, const Network& network, std::uint64_t limit, Tally& tally) {
    const TimedResult timed = check_timed(network, {.max_states = limit});
    if (!timed.complete || !timed.errors.empty()) return;
    Diagnostics diagnostics;
    const auto system = schedule_network(model, model.loops[{0}], derived(model).value(), network,
                                         {.plant = PlantApproach::Automata, .time = TimeModel::Discrete}, diagnostics);
    ASSERT_TRUE(system);
    ASSERT_EQ(verify(*system), std::vector<std::string>{});
    const SymbolicResult counted = check_symbolic(*system);
    ASSERT_FALSE(counted.fault.has_value());
    EXPECT_EQ(counted.states, std::to_string(timed.states));
    for (const Verdict& there : timed.verdicts)
        for (const Verdict& here : counted.verdicts) {
            if (here.property != there.property || there.outcome == Outcome::Unknown) continue;
            EXPECT_EQ(here.outcome, there.outcome) << here.property;
            ++tally.verdicts;
        }
    tally.states += timed.states;
    ++tally.loops;
}

TEST(RandomizedDiscreteTime, ARandomLoopHasTheStatesAndVerdictsOfTheTimedEngine) {
    const int cases = test_size(60);
    Tally tally;
    for (int seed = 1; seed <= cases; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        Model model = random_loop(random);
        if (seed % 2 == 0) add_task_cycles(model, random);
        const ClosedLoop& loop = model.loops[{0}];
        Diagnostics diagnostics;
        const auto equations = derived(model);
        const auto plant_network = plant(model, loop, diagnostics);
        if (!plant_network || !equations) continue;
        for (const Grain grain : {Grain::Atomic, Grain::Phased}) {
            const auto network = compose(*plant_network, loop, *equations, {grain, {}, {}}, diagnostics);
            if (!network) continue;
            if (clock_count(*network) > most_clocks) {
                ++tally.left_out;
                continue;
            }
            ASSERT_NO_FATAL_FAILURE(compare(model, *network, 3000, tally));
        }
    }
    std::cout << "seeds 1 to " << cases << ": " << tally.loops << " loops, " << tally.states << " states, "
              << tally.verdicts << " verdicts, " << tally.left_out << " omitted\n";
    EXPECT_GT(tally.loops, 20U);
}

TEST(RandomizedDiscreteTime, TheSamplesHaveTheStatesAndVerdictsOfTheTimedEngine) {
    Tally tally;
    for (const char* sample : {"blinker/blinker.grafcet", "oven_door/oven_door.grafcet", "tanks/tanks.grafcet"}) {
        SCOPED_TRACE(sample);
        const LoopUnderTest loop = read_sample(sample, {.grain = Grain::Atomic});
        compare(loop.model, loop.network, 10'000, tally);
    }
    EXPECT_EQ(tally.loops, 3U);
}

}  // namespace
}  // namespace grafverif
