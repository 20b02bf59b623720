// SPDX-License-Identifier: MIT
#include "run/network_walk.hpp"

#include <gtest/gtest.h>

#include "support/random_walk.hpp"
#include "support/read_loop.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

const char* const valve_loop = R"(
    grafcet hold { input OPEN; output ORDER; initial step 0 { ORDER; } step 1; transition t: 0 -> 1 when OPEN; }
    closed_loop one {
        controller hold with every_cycle;
        plant Valve = valve(ORDER = ORDER, FLOW = OPEN, TRAVEL = 3s);
        plant Light = lamp(ON = ORDER);
    }
)";

/// Takes edges until none is enabled.
NetworkState rested(const Network& network, NetworkState state) {
    for (auto moves = enabled(network, state); !moves.empty(); moves = enabled(network, state))
        perform(network, state, moves.front());
    return state;
}

TEST(NetworkWalk, TimeStopsWhileAnUrgentEdgeIsEnabled) {
    const LoopUnderTest loop = read_loop(valve_loop);
    const NetworkState start = initial_state(loop.network);
    EXPECT_FALSE(leeway(loop.network, start).may_pass);
    EXPECT_FALSE(impatient(loop.network, start).empty());
}

TEST(NetworkWalk, AnInvariantLimitsTheDelay) {
    const LoopUnderTest loop = read_loop(valve_loop);
    NetworkState state = rested(loop.network, initial_state(loop.network));
    const std::int64_t travel = 3000 / loop.network.time_unit_ms;
    EXPECT_EQ(leeway(loop.network, state), (Leeway{true, travel, travel}));
    EXPECT_TRUE(impatient(loop.network, state).empty());
    ASSERT_EQ(perform(loop.network, state, Delay{travel}).result, Step::Result::Done);
    EXPECT_FALSE(leeway(loop.network, state).may_pass);
    const auto hurried = impatient(loop.network, state);
    ASSERT_EQ(hurried.size(), 1u);
    EXPECT_EQ(loop.network.processes[hurried[0]].name, "Valve");
    state = rested(loop.network, state);  // the valve is open and about to close, because the order has ended
    ASSERT_EQ(leeway(loop.network, state), (Leeway{true, travel, travel}));
    ASSERT_EQ(perform(loop.network, state, Delay{travel}).result, Step::Result::Done);
    EXPECT_EQ(leeway(loop.network, rested(loop.network, state)), (Leeway{true, {}, {}}));
}

TEST(RandomizedNetworkWalk, LeewayIsExactlyTheTimeThatMayPass) {
    for (const char* sample :
         {"oven_door/oven_door.grafcet", "tanks/tanks.grafcet", "testing_station/testing_station.grafcet"}) {
        const Network network = read_sample(sample).network;
        Random random(7);
        const auto run = random_walk(network, random, test_size(300));
        NetworkState state = initial_state(network);
        for (const Move& move : run.moves) {
            perform(network, state, move);
            const Leeway delay = leeway(network, state);
            ASSERT_EQ(delay.may_pass, may_delay(network, state));
            if (!delay.may_pass) continue;
            NetworkState later = state;
            const std::int64_t far = delay.limit.value_or(1000);
            EXPECT_EQ(perform(network, later, Delay{far}).result, Step::Result::Done);
            EXPECT_TRUE(!delay.limit || !may_delay(network, later));
            // No edge becomes enabled before `change`, and at least one edge becomes enabled then.
            const auto now = enabled(network, state).size();
            for (std::int64_t units = 1; units < std::min(delay.change.value_or(5), far); ++units) {
                NetworkState between = state;
                perform(network, between, Delay{units});
                EXPECT_LE(enabled(network, between).size(), now);
            }
            if (!delay.change || *delay.change > far) continue;
            NetworkState then = state;
            ASSERT_EQ(perform(network, then, Delay{*delay.change}).result, Step::Result::Done);
            EXPECT_GT(enabled(network, then).size(), 0u);
        }
    }
}

}  // namespace
}  // namespace grafverif
