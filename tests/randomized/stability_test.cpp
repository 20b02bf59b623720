// SPDX-License-Identifier: MIT
// Randomized tests of the interpreter alone: a stable situation does not change in a further cycle, and a reported
// total instability cycles through its situations forever.
#include <gtest/gtest.h>

#include "run/interpreter.hpp"
#include "support/random_chart.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

std::vector<std::int64_t> random_inputs(const Chart& chart, Random& random) {
    std::vector<std::int64_t> values;
    for (const Chart::Variable& variable : chart.variables)
        values.push_back(random_number(random, variable.type.low, variable.type.high));
    return values;
}

bool broken(const Cycle& cycle) { return cycle.race || cycle.fault || !cycle.endless.empty() || cycle.gave_up; }

TEST(RandomizedStability, OneMoreCycleWithTheSameInputsChangesNothingInAStableSituation) {
    int seen = 0;
    for (int seed = 1; seed <= test_size(500); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Chart chart = random_chart(random);
        State state = power_on(chart);
        for (int k = 0; k < 10; ++k) {
            const std::vector<std::int64_t> inputs = random_inputs(chart, random);
            const Cycle first = cycle(chart, state, inputs, ExecutionMode::StabilitySearch);
            if (broken(first)) break;
            for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle}) {
                const Cycle again = cycle(chart, first.state, inputs, mode);
                ASSERT_EQ(again.state, first.state) << "seed " << seed << "\n\n" << chart_text(chart);
                ASSERT_EQ(again.fired, std::vector<std::vector<Id<Chart::Transition>>>(1)) << "seed " << seed;
            }
            ++seen;
            state = pass_time(first.state, 500 * random_number(random, 0, 6));
        }
    }
    EXPECT_GT(seen, 1000);
}

TEST(RandomizedStability, TotalInstabilityCyclesThroughItsSituationsForever) {
    int seen = 0;
    for (int seed = 1; seed <= test_size(500); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Chart chart = random_chart(random);
        const std::vector<std::int64_t> inputs = random_inputs(chart, random);
        const Cycle endless = cycle(chart, power_on(chart), inputs, ExecutionMode::StabilitySearch);
        if (endless.endless.empty()) continue;
        ++seen;
        State state = endless.state;
        for (std::size_t k = 0; k < 3 * endless.endless.size(); ++k) {
            ASSERT_EQ(state.situation, endless.endless[k % endless.endless.size()]) << "seed " << seed << "\n\n"
                                                                                    << chart_text(chart);
            const Evolution next = evolve(chart, state, inputs, time_conditions(chart, state));
            ASSERT_FALSE(next.stable || next.race || next.fault) << "seed " << seed;
            state = next.state;
        }
        EXPECT_EQ(state, endless.state);
    }
    EXPECT_GT(seen, 20);
}

}  // namespace
}  // namespace grafverif
