// SPDX-License-Identifier: MIT
// Tests the timed engine on the samples: the published verdicts and the resource limits.
#include <gtest/gtest.h>

#include "support/read_loop.hpp"
#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

TEST(TimedEngineOnSamples, GivesThePublishedVerdictsOfTheTestingStation) {
    for (const Grain grain : {Grain::Phased, Grain::Atomic}) {
        const TimedResult result =
            checked(read_sample("testing_station/testing_station.grafcet", {.grain = grain}).network);
        for (const char* property : {"P14", "P15", "no_deadlock", "no_timelock"})
            EXPECT_EQ(outcome_text(result, property), "holds") << property;
        EXPECT_TRUE(result.errors.empty());
    }
}

TEST(TimedEngineOnSamples, StoresTheTestingStationIn64BytesAState) {
    const TimedResult result = check_timed(read_sample("testing_station/testing_station.grafcet").network);
    EXPECT_GT(result.states, 3000u);
    EXPECT_LE(result.bytes, 64 * result.states);
}

TEST(TimedEngineOnSamples, GivesThePublishedVerdictsOfTheOvenDoor) {
    const TimedResult result = checked(read_sample("oven_door/oven_door.grafcet").network);
    EXPECT_GE(result.verdicts.size(), 5u);
    for (const Verdict& verdict : result.verdicts)
        EXPECT_EQ(outcome_text(result, verdict.property), "holds") << verdict.property << verdict.reason;
}

}  // namespace
}  // namespace grafverif
