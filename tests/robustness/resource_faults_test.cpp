// SPDX-License-Identifier: MIT
// Tests the process while the system refuses resources: each allocation of the SAT engines separately, and threads.
#include "robustness/resource_faults.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <system_error>

#include "app/serve/live_page.hpp"
#include "check/pdr/check.hpp"
#include "check/portfolio.hpp"
#include "support/untimed_loop.hpp"
#include "unit/app/run_program.hpp"

namespace grafverif::app {
namespace {

const std::string lamp =
    "grafcet lamp { input ON, OFF; output LAMP; initial step 0; step 1 { LAMP; }\n"
    "transition on: 0 -> 1 when ON; transition off: 1 -> 0 when OFF && !ON; }\n"
    "closed_loop room { controller lamp; environment a = free(OUT = ON); environment b = free(OUT = OFF);\n"
    "property lit: reachable LAMP; property one: exactly one of { X0, X1 }; property never_lit: never LAMP; }\n";

TEST(RefusedMemory, VerdictsOfTheSolversAreUnknownOrCorrect) {
    if (sanitized) GTEST_SKIP() << "sanitizers replace the allocator";
    using Method = PdrOptions::Method;
    const TransitionSystem system = untimed_text(lamp, {.plant = PlantApproach::Automata});
    std::size_t refused = 0;
    for (const Method method : {Method::Pdr, Method::Bmc, Method::Alternating}) {
        PdrOptions options;
        options.method = method;
        if (method == Method::Bmc) options.max_steps = 6;
        constexpr std::int64_t many = std::int64_t{1} << 40;
        std::int64_t made = 0;
        PdrResult expected;
        {
            const Refusal count(many);
            expected = check_pdr(system, options);
            made = many - count.left();
        }
        ASSERT_GT(made, 1000);
        for (std::int64_t after = 0; after < made; after += std::max<std::int64_t>(1, made / 400)) {
            PdrResult found;
            try {
                const Refusal refusal(after);
                found = check_pdr(system, options);
            } catch (const std::bad_alloc&) {
                continue;
            }
            SCOPED_TRACE(after);
            EXPECT_TRUE(found.failures.empty()) << found.failures.front();
            for (std::size_t k = 0; k < found.verdicts.size(); ++k) {
                const Verdict& verdict = found.verdicts[k];
                if (verdict.obstacle == UnknownReason::Memory) ++refused;
                else EXPECT_EQ(verdict.outcome, expected.verdicts[k].outcome) << verdict.property << verdict.reason;
            }
        }
    }
    EXPECT_GT(refused, 100U);
}

TEST(RefusedThreads, AreReportedWithTheirOwnCode) {
    if (sanitized) GTEST_SKIP() << "sanitizers replace the same function";
    const Folder folder;
    const std::vector<std::string> words{"serve", folder.write("lamp.grafcet", lamp)};
    Result result;
    {
        const FewThreads few(0);
        result = grafverif(words);
    }
    EXPECT_EQ(result.code, ExitCode::Unknown);
    EXPECT_NE(result.err.find("[threads-refused]"), std::string::npos) << result.err;
}

TEST(RefusedThreads, LeaveTheWorkOfThePortfolioToTheCaller) {
#ifdef SANITIZED
    GTEST_SKIP() << "sanitizers replace the same function";
#endif
    const TransitionSystem system = untimed_text(lamp, {.plant = PlantApproach::Automata});
    const PortfolioResult expected = check_together(system);
    for (const int count : {0, 1}) {
        PortfolioResult found;
        {
            const FewThreads few(count);
            found = check_together(system);
        }
        EXPECT_FALSE(found.alone);
        ASSERT_EQ(found.verdicts.size(), expected.verdicts.size());
        for (std::size_t i = 0; i < found.verdicts.size(); ++i) {
            EXPECT_NE(found.verdicts[i].outcome, Outcome::Unknown);
            EXPECT_EQ(found.verdicts[i].outcome, expected.verdicts[i].outcome) << found.verdicts[i].property;
        }
    }
}

TEST(RefusedThreads, LeaveTheWorkOfMutateToTheOthers) {
    if (sanitized) GTEST_SKIP() << "sanitizers replace the same function";
    const Folder folder;
    const std::vector<std::string> words{"mutate", folder.write("lamp.grafcet", lamp), "--jobs", "3"};
    const Result all = grafverif(words);
    for (const int count : {1, 2}) {
        const FewThreads few(count);
        const Result fewer = grafverif(words);
        EXPECT_EQ(fewer.code, all.code) << fewer.err;
    }
}

TEST(RefusedThreads, LetServeStartOrEnd) {
    if (sanitized) GTEST_SKIP() << "sanitizers replace the same function";
    const Folder folder;
    Options options;
    options.operands = {folder.write("lamp.grafcet", lamp)};
    int started = 0;
    for (int count = 0; count < 8; ++count) {
        const FewThreads few(count);
        try {
            const LivePage page(options);
            ++started;
        } catch (const std::system_error& failure) {
            EXPECT_EQ(failure.code(), std::errc::resource_unavailable_try_again) << count;
        }
    }
    EXPECT_GT(started, 0);
    EXPECT_LT(started, 8);
}

}  // namespace
}  // namespace grafverif::app
