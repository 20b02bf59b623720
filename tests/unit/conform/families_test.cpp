// SPDX-License-Identifier: MIT
// Tests location automata and test sequences of scalable families of charts (bench/families.hpp). The expected counts
// are those of an implementation of the published method.
#include "families.hpp"

#include "unit/conform/conforming.hpp"

namespace grafverif {
namespace {

/// Returns the declarations of the only chart of `text`, without the enclosing `grafcet NAME { }`.
std::string body(const std::string& text) {
    return text.substr(text.find('{') + 1, text.rfind('}') - text.find('{') - 1);
}

TEST(Families, HaveTheCountsOfThePublishedMethod) {
    const AutomatonCounts parallel = counts(automaton(body(bench::basic_parallel(3, 2))));
    EXPECT_EQ(parallel.locations, 15'132U);
    EXPECT_EQ(parallel.evolutions, 76'265U);
    const AutomatonCounts hierarchical = counts(automaton(body(bench::hierarchical_parallel(8, 3))));
    EXPECT_EQ(hierarchical.locations, 6'562U);
    EXPECT_EQ(hierarchical.evolutions, 52'497U);
}

/// Returns n^m.
std::uint64_t power(std::uint64_t n, std::uint64_t m) { return m == 0 ? 1 : n * power(n, m - 1); }

TEST(Families, GrowAsTheirFormulasState) {
    for (const std::size_t steps : {2U, 3U, 20U}) {
        const AutomatonCounts ring = counts(automaton(body(bench::basic_sequence(steps))));
        EXPECT_EQ(ring.locations, steps + 1);
        EXPECT_EQ(ring.evolutions - ring.evolutions_from_init, steps);
    }
    for (std::size_t rings = 1; rings <= 4; ++rings)
        for (std::size_t steps = 2; steps <= 4; ++steps) {
            const AutomatonCounts parallel = counts(automaton(body(bench::hierarchical_parallel(rings, steps))));
            EXPECT_EQ(parallel.locations, power(steps, rings) + 1);
            EXPECT_EQ(parallel.evolutions - parallel.evolutions_from_init, rings * power(steps, rings));
        }
}

TEST(Families, HaveToursNoLongerThanThePublishedMethodFinds) {
    const TestSequence test = test_of(machine(automaton(body(bench::hierarchical_parallel(6, 3)))));
    EXPECT_EQ(step_count(test), 18'954U);
    EXPECT_TRUE(test.proven_least);
    EXPECT_EQ(test.covered, 729U * 32U);
}

}  // namespace
}  // namespace grafverif
