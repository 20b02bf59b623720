// SPDX-License-Identifier: MIT
#include "bdd/bdd.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "support/random_chart.hpp"

namespace grafverif {
namespace {

constexpr std::uint32_t variable_count = 6;

std::vector<std::uint32_t> all_variables(std::size_t count = variable_count) {
    std::vector<std::uint32_t> variables(count);
    std::iota(variables.begin(), variables.end(), 0U);
    return variables;
}

std::vector<bool> assignment(unsigned number, std::size_t count = variable_count) {
    std::vector<bool> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = ((number >> i) & 1U) != 0;
    return values;
}

/// A random function with its truth table. Bit n is the value of the function under assignment(n).
struct Function {
    Bdd bdd = {};
    std::uint64_t table = 0;
};

constexpr unsigned assignments = 1U << variable_count;

Function variable_of(const BddSpace& space, std::uint32_t index) {
    Function result{space.variable(index), 0};
    for (unsigned n = 0; n < assignments; ++n)
        if (assignment(n)[index]) result.table |= std::uint64_t{1} << n;
    return result;
}

Function random_function(const BddSpace& space, Random& random, int depth = 4) {
    if (depth == 0) return variable_of(space, static_cast<std::uint32_t>(random_number(random, 0, variable_count - 1)));
    const Function f = random_function(space, random, depth - 1);
    const Function g = random_function(space, random, depth - 1);
    switch (random_number(random, 0, 5)) {
    case 0: return {f.bdd & g.bdd, f.table & g.table};
    case 1: return {f.bdd | g.bdd, f.table | g.table};
    case 2: return {f.bdd ^ g.bdd, f.table ^ g.table};
    case 3: return {~f.bdd, ~f.table};
    case 4: return {implies(f.bdd, g.bdd), ~f.table | g.table};
    default: return {iff(f.bdd, g.bdd), ~(f.table ^ g.table)};
    }
}

std::uint64_t table_of(const Bdd& f) {
    std::uint64_t table = 0;
    for (unsigned n = 0; n < assignments; ++n)
        if (evaluate(f, assignment(n))) table |= std::uint64_t{1} << n;
    return table;
}

/// Returns the truth table that contains `value_at(n)` for each assignment n.
template <class ValueAt>
std::uint64_t table(const ValueAt& value_at) {
    std::uint64_t result = 0;
    for (unsigned n = 0; n < assignments; ++n)
        if (value_at(n)) result |= std::uint64_t{1} << n;
    return result;
}

bool at(std::uint64_t table, unsigned n) { return ((table >> n) & 1U) != 0; }

TEST(Bdd, ConnectivesAgreeWithTruthTables) {
    BddSpace space;
    space.add_variables(variable_count);
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        const Function f = random_function(space, random), g = random_function(space, random),
                       h = random_function(space, random);
        EXPECT_EQ(table_of(f.bdd), f.table);
        EXPECT_EQ(table_of(ite(f.bdd, g.bdd, h.bdd)), (f.table & g.table) | (~f.table & h.table));
        EXPECT_EQ(f.bdd == g.bdd, f.table == g.table) << "equal functions are equal handles";
    }
}

TEST(Bdd, QuantifiersAndCofactorsAgreeWithTruthTables) {
    BddSpace space;
    space.add_variables(variable_count);
    const Bdd quantified = variable_set(space, std::vector<std::uint32_t>{1, 4});
    const auto some = [](std::uint64_t t, unsigned n) {
        const unsigned others = n & ~0b10010U;
        return at(t, others) || at(t, others | 0b10U) || at(t, others | 0b10000U) || at(t, others | 0b10010U);
    };
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        const Function f = random_function(space, random), g = random_function(space, random);
        EXPECT_EQ(table_of(exists(f.bdd, quantified)), table([&](unsigned n) { return some(f.table, n); }));
        EXPECT_EQ(and_exists(f.bdd, g.bdd, quantified), exists(f.bdd & g.bdd, quantified));
        const Bdd half = cofactor(f.bdd, cube(space, std::vector<BddLiteral>{{1, true}, {4, false}}));
        EXPECT_EQ(table_of(half), table([&](unsigned n) { return at(f.table, (n | 0b10U) & ~0b10000U); }));
        if (!g.bdd.is_false()) {
            EXPECT_EQ(simplify(f.bdd, g.bdd) & g.bdd, f.bdd & g.bdd);
        }
    }
}

TEST(Bdd, RenamingActsOnAllVariablesAtOnce) {
    BddSpace space;
    space.add_variables(variable_count);
    const BddRenaming swapped(std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 5}, {5, 0}, {2, 3}, {3, 2}});
    const auto swap_bits = [](unsigned n) {
        const std::vector<bool> v = assignment(n);
        return (v[5] ? 1U : 0U) | (v[1] ? 2U : 0U) | (v[3] ? 4U : 0U) | (v[2] ? 8U : 0U) | (v[4] ? 16U : 0U) |
               (v[0] ? 32U : 0U);
    };
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        const Function f = random_function(space, random);
        EXPECT_EQ(table_of(swapped(f.bdd)), table([&](unsigned n) { return at(f.table, swap_bits(n)); }));
    }
}

TEST(Bdd, CubesAreDisjointAndMakeUpTheFunction) {
    BddSpace space;
    space.add_variables(variable_count);
    Random random(4);
    for (int i = 0; i < 100; ++i) {
        SCOPED_TRACE(i);
        const Function f = random_function(space, random);
        Bdd together;
        for_each_cube(f.bdd, [&](std::span<const BddLiteral> literals) {
            const Bdd one = cube(space, literals);
            EXPECT_TRUE((one & together).is_false());
            together |= one;
            return true;
        });
        EXPECT_EQ(together, f.bdd);
        const auto first = one_cube(f.bdd);
        ASSERT_EQ(first.has_value(), !f.bdd.is_false());
        if (first) {
            EXPECT_TRUE(implies(cube(space, *first), f.bdd).is_true());
        }
    }
}

TEST(Bdd, VisitingCubesStopsOnRequest) {
    BddSpace space;
    space.add_variables(2);
    int visits = 0;
    for_each_cube(space.variable(0) ^ space.variable(1), [&](std::span<const BddLiteral>) { return ++visits < 1; });
    EXPECT_EQ(visits, 1);
}

TEST(Bdd, CountsAreExact) {
    BddSpace space;
    space.add_variables(variable_count);
    Random random(5);
    for (int i = 0; i < 100; ++i) {
        const Function f = random_function(space, random);
        EXPECT_EQ(small_count(f.bdd, all_variables()), std::popcount(f.table));
    }
    space.add_variables(200 - variable_count);
    const std::vector<std::uint32_t> many = all_variables(200);
    EXPECT_EQ(count(Bdd::constant(true), many), "1606938044258990275541962092341162602522202993782792835301376")
        << "2^200";
    EXPECT_EQ(count(Bdd::constant(false), many), "0");
    EXPECT_EQ(count(~cube(space, std::vector<BddLiteral>{{0, true}, {70, false}}), all_variables(100)),
              "950737950171172051122527404032")
        << "three quarters of 2^100";
    EXPECT_FALSE(small_count(Bdd::constant(true), many));
    EXPECT_EQ(small_count(space.variable(3), std::vector<std::uint32_t>{3, 150}), 2u);
}

TEST(Bdd, SupportAndSizeReferToTheReducedDiagram) {
    BddSpace space;
    space.add_variables(4);
    const Bdd a = space.variable(0), b = space.variable(1), d = space.variable(3);
    EXPECT_EQ(support((a & d) | (~a & d & b) | (~a & d & ~b)), std::vector<std::uint32_t>{3});
    EXPECT_EQ(support(a ^ d), (std::vector<std::uint32_t>{0, 3}));
    EXPECT_EQ(size(a ^ d), 2u) << "a function and its complement share their nodes";
    EXPECT_TRUE(support(Bdd::constant(true)).empty());
    EXPECT_EQ((a & d).top(), 0u);
    EXPECT_EQ((a & d).high(), d);
    EXPECT_TRUE((a & d).low().is_false());
}

/// Returns a function with an exponential diagram: it pairs variables that are distant in the order.
Bdd widely_separated(const BddSpace& space, std::uint32_t pairs) {
    Bdd result = Bdd::constant(true);
    for (std::uint32_t i = 0; i < pairs; ++i) result &= iff(space.variable(i), space.variable(i + pairs));
    return result;
}

TEST(Bdd, MemoryBoundIsKeptAndAllFunctionsRemain) {
    BddSpace space({.memory = 8U << 20U});
    space.add_variables(60);
    const Bdd before = widely_separated(space, 8);
    const std::string counted = count(before, all_variables(60));
    try {
        widely_separated(space, 30);
        FAIL() << "2^30 nodes exceed the memory limit";
    } catch (const BddExhausted& exhausted) {
        EXPECT_EQ(exhausted.cause(), BddExhausted::Cause::Memory);
    }
    EXPECT_LE(space.bytes(), 8U << 20U);
    EXPECT_EQ(count(before, all_variables(60)), counted);
    EXPECT_EQ(widely_separated(space, 8), before) << "the space remains usable and has stored no wrong result";
}

TEST(Bdd, StoppingEndsALongOperation) {
    std::atomic<bool> stop = false;
    BddSpace space({.stop = &stop});
    space.add_variables(40);
    const Bdd before = widely_separated(space, 4);
    stop = true;
    EXPECT_THROW(widely_separated(space, 20), BddExhausted);
    stop = false;
    EXPECT_EQ(widely_separated(space, 4), before);
}

TEST(Bdd, ADeadlineEndsALongOperation) {
    BddSpace space({.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(50)});
    space.add_variables(60);
    try {
        widely_separated(space, 30);
        FAIL();
    } catch (const BddExhausted& exhausted) {
        EXPECT_EQ(exhausted.cause(), BddExhausted::Cause::Stopped);
    }
}

TEST(Bdd, SpacesCanBeCreatedSuccessively) {
    for (int i = 0; i < 3; ++i) {
        BddSpace space;
        EXPECT_EQ(space.variables(), 0u);
        EXPECT_EQ(space.add_variables(3), 0u);
        const Bdd f = space.variable(0) & space.variable(2);
        EXPECT_EQ(space.add_variables(2), 3u);
        EXPECT_EQ(f & space.variable(4), cube(space, std::vector<BddLiteral>{{4, true}, {0, true}, {2, true}}));
    }
}

}  // namespace
}  // namespace grafverif
