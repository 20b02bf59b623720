// SPDX-License-Identifier: MIT
// Refusals of the system in this process: one allocation after another in the SAT engines, and threads.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <system_error>

#include "app/serve/live_page.hpp"
#include "check/pdr/check.hpp"
#include "support/untimed_loop.hpp"
#include "unit/app/run_program.hpp"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SANITIZED  // sanitizers replace the same functions
#endif

namespace {

thread_local std::int64_t allocations_left = -1;  ///< number of allocations before one is refused; negative: none is
thread_local int threads_left = -1;               ///< number of threads that this one may start; negative: unlimited

}  // namespace

#ifndef SANITIZED
// Not inlined: GCC would warn about `free` of a pointer from `operator new`.
[[gnu::noinline]] void* operator new(std::size_t size) {
    if (allocations_left >= 0 && allocations_left-- == 0) throw std::bad_alloc();
    if (void* const memory = std::malloc(std::max<std::size_t>(size, 1))) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*),
                              void* argument) noexcept {
    using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    static const auto create = reinterpret_cast<Create>(::dlsym(RTLD_NEXT, "pthread_create"));
    if (threads_left == 0) return EAGAIN;
    if (threads_left > 0) --threads_left;
    return create(thread, attributes, work, argument);
}
#endif

namespace grafverif::app {
namespace {

const std::string lamp =
    "grafcet lamp { input ON, OFF; output LAMP; initial step 0; step 1 { LAMP; }\n"
    "transition on: 0 -> 1 when ON; transition off: 1 -> 0 when OFF && !ON; }\n"
    "closed_loop room { controller lamp; environment a = free(OUT = ON); environment b = free(OUT = OFF);\n"
    "property lit: reachable LAMP; property one: exactly one of { X0, X1 }; property never_lit: never LAMP; }\n";

/// Refuses one allocation of this thread, after the given number, while it exists.
class Refusal {
public:
    explicit Refusal(std::int64_t after) { allocations_left = after; }
    ~Refusal() { allocations_left = -1; }
    Refusal(const Refusal&) = delete;
    Refusal& operator=(const Refusal&) = delete;
};

TEST(RefusedMemory, VerdictsOfTheSolversAreUnknownOrCorrect) {
#ifdef SANITIZED
    GTEST_SKIP() << "sanitizers have their own allocator";
#endif
    using Method = PdrOptions::Method;
    const TransitionSystem system = untimed_text(lamp, {.plant = PlantApproach::Automata});
    std::size_t refused = 0;
    for (const Method method : {Method::Pdr, Method::Bmc, Method::InTurns}) {
        PdrOptions options;
        options.method = method;
        if (method == Method::Bmc) options.max_steps = 6;
        constexpr std::int64_t many = std::int64_t{1} << 40;
        std::int64_t made = 0;
        PdrResult expected;
        {
            const Refusal count(many);
            expected = check_pdr(system, options);
            made = many - allocations_left;
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
                if (verdict.obstacle == Obstacle::Memory) ++refused;
                else EXPECT_EQ(verdict.outcome, expected.verdicts[k].outcome) << verdict.property << verdict.reason;
            }
        }
    }
    EXPECT_GT(refused, 100U);
}

/// Refuses threads beyond the given number, started by this thread, while it exists.
class FewThreads {
public:
    explicit FewThreads(int count) { threads_left = count; }
    ~FewThreads() { threads_left = -1; }
    FewThreads(const FewThreads&) = delete;
    FewThreads& operator=(const FewThreads&) = delete;
};

TEST(RefusedThreads, AreReportedWithTheirOwnCode) {
#ifdef SANITIZED
    GTEST_SKIP() << "sanitizers replace the same function";
#endif
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", lamp);
    const std::vector<std::string> words{"check",  file, "--untimed", "--plant", "automata",
                                         "--jobs", "1",  "--engine",  "auto",    "--whole"};
    for (const int count : {0, 1}) {
        Result result;
        {
            const FewThreads few(count);
            result = grafverif(words);
        }
        EXPECT_EQ(result.code, ExitCode::Unknown) << count;
        EXPECT_NE(result.err.find("[threads-refused]"), std::string::npos) << count << result.err;
    }
}

TEST(RefusedThreads, LeaveTheWorkOfMutateToTheOthers) {
#ifdef SANITIZED
    GTEST_SKIP() << "sanitizers replace the same function";
#endif
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
#ifdef SANITIZED
    GTEST_SKIP() << "sanitizers replace the same function";
#endif
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
