// SPDX-License-Identifier: MIT
// Tests the guarantees of a BDD space about memory, time, depth, and independence of other spaces.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "bdd/bdd.hpp"

namespace grafverif {
namespace {

using Clock = std::chrono::steady_clock;
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Returns a function that is true if both variables of each pair of neighbours are equal; its diagram is small.
Bdd neighbours(const BddSpace& space, std::uint32_t pairs) {
    Bdd result = Bdd::constant(true);
    for (std::uint32_t i = pairs; i-- > 0;) result &= iff(space.variable(2 * i), space.variable(2 * i + 1));
    return result;
}

/// Renames the variables so that the variables of a pair are no longer neighbours. The renaming is
/// a single operation that creates more than 2^n nodes for n pairs.
struct TakenApart {
    explicit TakenApart(std::uint32_t pairs) : renaming(moves(pairs)) {}

    static Pairs moves(std::uint32_t pairs) {
        Pairs moves;
        for (std::uint32_t i = 0; i < pairs; ++i) {
            moves.emplace_back(2 * i, i);
            moves.emplace_back(2 * i + 1, pairs + i);
        }
        return moves;
    }

    BddRenaming renaming;
};

constexpr std::uint32_t many = 30;  // 2^30 nodes would take too long

BddExhausted::Cause cause_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const BddExhausted& exhausted) {
        return exhausted.cause();
    }
    ADD_FAILURE() << "the operation did not fail";
    return {};
}

TEST(BddLimits, MemoryBoundHoldsWithinAnOperationAndAllFunctionsRemain) {
    for (const std::uint64_t memory : {std::uint64_t{1} << 18U, std::uint64_t{1} << 20U, std::uint64_t{9} << 20U}) {
        BddSpace space({.memory = memory});
        space.add_variables(2 * many);
        const Bdd f = neighbours(space, many);
        const TakenApart apart(many);
        const std::string counted = count(f, support(f));
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(cause_of([&] { (void)apart.renaming(f); }), BddExhausted::Cause::Memory);
            EXPECT_LE(space.bytes(), memory);
            EXPECT_GE(space.bytes(), memory / 2) << "the available memory is used";
            EXPECT_EQ(verify(space), std::vector<std::string>());
            EXPECT_EQ(count(f, support(f)), counted);
            EXPECT_EQ(neighbours(space, many), f);
        }
    }
}

TEST(BddLimits, SpaceWithoutMemoryReportsIt) {
    BddSpace space({.memory = 1000});
    EXPECT_EQ(cause_of([&] {
                  space.add_variables(3);
                  (void)space.variable(0);
              }),
              BddExhausted::Cause::Memory);
    EXPECT_LE(space.bytes(), 1000u);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/// Returns the size of the address space of this process, in bytes.
rlim_t address_space() {
    std::ifstream pages("/proc/self/statm");
    rlim_t count = 0;
    pages >> count;
    return count * 4096;
}

[[noreturn]] void work_where_memory_is_refused() {
    BddSpace space;
    space.add_variables(2 * many);
    const Bdd f = neighbours(space, many);
    const TakenApart apart(many);
    const rlimit limit{address_space() + (rlim_t{20} << 20U), RLIM_INFINITY};
    setrlimit(RLIMIT_AS, &limit);
    bool good = true;
    for (int i = 0; i < 3; ++i) {
        good = good && cause_of([&] { (void)apart.renaming(f); }) == BddExhausted::Cause::Memory;
        good = good && neighbours(space, many) == f && verify(space).empty();
    }
    std::_Exit(good && space.bytes() > (10U << 20U) ? 0 : 1);
}

TEST(BddLimitsDeathTest, RefusedAllocationCountsAsExhaustedMemoryAndAllFunctionsRemain) {
    if (address_space() == 0) GTEST_SKIP() << "/proc is not available";
    EXPECT_EXIT(work_where_memory_is_refused(), testing::ExitedWithCode(0), "");
}
#endif

TEST(BddLimits, LongOperationStopsAtItsDeadline) {
    const Clock::time_point start = Clock::now();
    BddSpace space({.deadline = start + std::chrono::milliseconds(200)});
    space.add_variables(2 * many);
    const Bdd f = neighbours(space, many);
    EXPECT_EQ(cause_of([&] { (void)TakenApart(many).renaming(f); }), BddExhausted::Cause::Stopped);
    EXPECT_GE(Clock::now() - start, std::chrono::milliseconds(200));
    EXPECT_LE(Clock::now() - start, std::chrono::seconds(5)) << "the limit allows for a busy machine";
}

TEST(BddLimits, LongOperationStopsOnRequestOfAnotherThread) {
    std::atomic<bool> stop = false;
    BddSpace space({.stop = &stop});
    space.add_variables(2 * many);
    const Bdd f = neighbours(space, many);
    const TakenApart apart(many);
    // The request to stop arrives during growth, during garbage collection, or during node creation.
    for (const int wait : {1, 10, 40, 160}) {
        std::thread other([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(wait));
            stop = true;
        });
        EXPECT_EQ(cause_of([&] { (void)apart.renaming(f); }), BddExhausted::Cause::Stopped);
        other.join();
        stop = false;
        EXPECT_EQ(verify(space), std::vector<std::string>());
        EXPECT_EQ(neighbours(space, many), f);
    }
}

TEST(BddLimits, StoppingAtAnyPointKeepsTheSpaceConsistent) {
    for (int micros = 0; micros < 4000; micros += 150) {
        std::atomic<bool> stop = false;
        BddSpace space({.memory = 1U << 20U, .stop = &stop});
        space.add_variables(40);
        const Bdd f = neighbours(space, 20);
        const TakenApart apart(20);
        std::thread other([&] {
            std::this_thread::sleep_for(std::chrono::microseconds(micros));
            stop = true;
        });
        try {
            for (;;) {
                try {
                    (void)apart.renaming(f);  // 2^20 nodes exceed the memory limit after many garbage collections
                } catch (const BddExhausted& exhausted) {
                    if (exhausted.cause() == BddExhausted::Cause::Stopped) throw;
                }
                space.collect_garbage();
                space.reorder();
            }
        } catch (const BddExhausted&) {
        }
        other.join();
        stop = false;
        EXPECT_EQ(verify(space), std::vector<std::string>()) << micros;
        EXPECT_EQ(neighbours(space, 20), f) << micros;
        EXPECT_EQ(verify(space), std::vector<std::string>()) << micros;
    }
}

TEST(BddLimits, DeepDiagramsDoNotOverflowTheStack) {
    constexpr std::uint32_t depth = 20'000;
    BddSpace space;
    space.add_variables(depth + 1);
    Bdd odd, others;  // functions of the first `depth` variables, and of those variables without the first
    for (std::uint32_t i = depth; i-- > 0;) {
        others = odd;
        odd = odd ^ space.variable(i);
    }
    std::vector<std::uint32_t> all(depth);
    Pairs down;
    for (std::uint32_t i = 0; i < depth; ++i) {
        all[i] = i;
        down.emplace_back(i, i + 1);
    }
    const Bdd first = space.variable(0), set = variable_set(space, all);
    EXPECT_EQ(size(odd), depth);
    EXPECT_EQ(support(odd), all);
    EXPECT_EQ(cofactor(odd, first), ~others);
    EXPECT_EQ(odd & ~first, others & ~first);
    EXPECT_EQ(ite(odd, others, ~others), ~first);
    EXPECT_TRUE(exists(odd, set).is_true());
    EXPECT_TRUE(and_exists(odd, others, set).is_true());
    EXPECT_TRUE(and_exists(odd, ~odd ^ first ^ first, set).is_false());
    EXPECT_EQ(simplify(odd, first), ~others);
    const Bdd moved = BddRenaming(down)(odd);
    EXPECT_EQ(moved ^ odd, first ^ space.variable(depth));
    EXPECT_EQ(count(odd, all), count(~odd, all)) << "half of all assignments";
    EXPECT_EQ(one_cube(odd)->size(), depth);
    space.collect_garbage();
    EXPECT_EQ(verify(space), std::vector<std::string>());
}

TEST(BddLimits, SpacesAreIndependent) {
    BddSpace one, two;
    one.add_variables(8);
    two.add_variables(8);
    const Bdd f = neighbours(one, 4), g = neighbours(two, 3);
    std::vector<std::thread> threads;
    std::atomic<int> right = 0;
    for (int i = 0; i < 3; ++i)
        threads.emplace_back([&] {
            BddSpace own;
            own.add_variables(24);
            const Bdd h = TakenApart(12).renaming(neighbours(own, 12));
            if (small_count(h, support(h)) == 4096 && verify(own).empty()) ++right;
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(right, 3);
    EXPECT_EQ(small_count(f, support(f)), 16);
    EXPECT_EQ(small_count(g, support(g)), 8);
    EXPECT_EQ(f & Bdd::constant(true), f);
    EXPECT_EQ(g & Bdd::constant(true), g) << "constants can be combined with functions of every space";
}

TEST(BddOrder, SiftingFindsTheOrderThatPairsNeed) {
    BddSpace space;
    space.add_variables(24);
    const Bdd f = TakenApart(12).renaming(neighbours(space, 12));
    const std::size_t before = size(f);
    const auto models = count(f, support(f));
    space.reorder();
    EXPECT_EQ(verify(space), std::vector<std::string>());
    EXPECT_GT(before, 4000u);
    EXPECT_EQ(size(f), 35u) << "three nodes for each pair, two for the last pair";
    EXPECT_EQ(count(f, support(f)), models);
    std::vector<bool> values(24, true);
    EXPECT_TRUE(evaluate(f, values));
    values[3] = false;
    EXPECT_FALSE(evaluate(f, values));
    EXPECT_EQ(TakenApart(12).renaming(neighbours(space, 12)), f) << "the result does not depend on the order";
}

TEST(BddOrder, GroupsStayAdjacentInTheirOrder) {
    BddSpace space;
    space.add_variables(24);
    for (std::uint32_t first = 0; first < 24; first += 3) space.keep_together(first, 3);
    const Bdd f = TakenApart(12).renaming(neighbours(space, 12));
    const std::size_t before = size(f);
    space.reorder();
    EXPECT_LT(size(f), before / 4);
    const std::vector<std::uint32_t> order = space.order();
    for (std::size_t level = 0; level < 24; level += 3) {
        EXPECT_EQ(order[level] % 3, 0u);
        EXPECT_EQ(order[level + 1], order[level] + 1);
        EXPECT_EQ(order[level + 2], order[level] + 2);
    }
    EXPECT_EQ(verify(space), std::vector<std::string>());
}

TEST(BddOrder, SpaceReordersAutomaticallyIfEnabled) {
    BddSpace space;
    space.add_variables(2 * many);
    space.reorder_above(2000);
    Bdd f = Bdd::constant(true);
    for (std::uint32_t i = 0; i < many; ++i) f &= iff(space.variable(i), space.variable(many + i));
    EXPECT_LT(size(f), 1000u) << "without reordering: 2^30";
    EXPECT_EQ(count(f, support(f)), "1073741824");
    EXPECT_EQ(verify(space), std::vector<std::string>());
}

}  // namespace
}  // namespace grafverif
