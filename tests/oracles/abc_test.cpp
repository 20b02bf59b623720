// SPDX-License-Identifier: MIT
// Compares ABC as an engine with the embedded engines on random systems and on the controllers of random loops. The
// verdicts must be equal. The invariants and runs of ABC are validated in the same way as those of the embedded
// engines.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "app/engines.hpp"
#include "app/system/process.hpp"
#include "check/pdr/check.hpp"
#include "support/random_system.hpp"
#include "support/read_loop.hpp"
#include "support/test_size.hpp"
#include "support/untimed_loop.hpp"

namespace grafverif {
namespace {

struct Agreement {
    std::size_t verdicts = 0, proved = 0, runs = 0;
};

void expect_agreement(const TransitionSystem& system, Agreement& agreement) {
    const auto program = app::find_program("berkeley-abc");
    ASSERT_TRUE(program);
    const PdrResult own = check_pdr(system);
    PdrOptions options;
    options.reach = app::search_by_abc(program->string(), nullptr);
    const PdrResult theirs = check_pdr(system, options);
    ASSERT_EQ(own.failures, std::vector<std::string>{});
    ASSERT_EQ(theirs.failures, std::vector<std::string>{});
    ASSERT_EQ(theirs.fault.has_value(), own.fault.has_value());
    for (std::size_t i = 0; i < own.verdicts.size(); ++i) {
        SCOPED_TRACE(own.verdicts[i].property);
        ASSERT_EQ(theirs.verdicts[i].outcome, own.verdicts[i].outcome) << theirs.verdicts[i].reason;
        ASSERT_EQ(theirs.runs[i].has_value(), own.runs[i].has_value());
        if (own.verdicts[i].outcome == Outcome::Unknown) continue;
        ++agreement.verdicts;
        if (own.runs[i]) {
            EXPECT_LE(theirs.runs[i]->states.size(), own.runs[i]->states.size()) << "bmc3 finds a shortest run";
            ++agreement.runs;
        } else {
            ++agreement.proved;
        }
    }
}

TEST(Abc, AgreesWithThePdrEngineOnRandomSystems) {
    if (!app::find_program("berkeley-abc")) GTEST_SKIP() << "berkeley-abc is not installed";
    Agreement agreement;
    for (int seed = 1; seed <= test_size(6); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        TransitionSystem system = random_system(random);
        ask_more(system, random);
        ASSERT_NO_FATAL_FAILURE(expect_agreement(system, agreement));
    }
    std::cout << agreement.verdicts << " verdicts, " << agreement.proved << " by invariants, " << agreement.runs
              << " by runs\n";
    EXPECT_GT(agreement.proved, 3u);
    EXPECT_GT(agreement.runs, 5u);
}

TEST(Abc, AgreesWithThePdrEngineOnASample) {
    if (!app::find_program("berkeley-abc")) GTEST_SKIP() << "berkeley-abc is not installed";
    Agreement agreement;
    ASSERT_NO_FATAL_FAILURE(expect_agreement(untimed_sample("tanks/tanks.grafcet", {}), agreement));
    EXPECT_GT(agreement.proved, 1u);
    EXPECT_GT(agreement.runs, 0u);
}

}  // namespace
}  // namespace grafverif
