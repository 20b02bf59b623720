// SPDX-License-Identifier: MIT
// The scaling families, whose counts an implementation of the published method gives as well.
#include "families.hpp"

#include "unit/conform/conforming.hpp"

namespace grafverif {
namespace {

/// The declarations of the one chart of `text`, its frame left out.
std::string body(const std::string& text) { return text.substr(text.find('{') + 1, text.rfind('}') - text.find('{') - 1); }

TEST(Families, HaveTheCountsOfThePublishedMethod) {
    const AutomatonCounts parallel = counts(automaton(body(bench::basic_parallel(3, 2))));
    EXPECT_EQ(parallel.locations, 15'132U);
    EXPECT_EQ(parallel.evolutions, 76'265U);
    const AutomatonCounts hierarchical = counts(automaton(body(bench::hierarchical_parallel(8, 3))));
    EXPECT_EQ(hierarchical.locations, 6'562U);
    EXPECT_EQ(hierarchical.evolutions, 52'497U);
}

TEST(Families, GrowAsTheyAreBuilt) {
    EXPECT_EQ(counts(automaton(body(bench::basic_sequence(20)))).locations, 21U);
    EXPECT_EQ(counts(automaton(body(bench::hierarchical_parallel(4, 3)))).locations, 82U);
}

TEST(Families, HaveToursNoLongerThanThePublishedMethodFinds) {
    const TestSequence test = test_of(machine(automaton(body(bench::hierarchical_parallel(6, 3)))));
    EXPECT_EQ(step_count(test), 18'954U);
    EXPECT_TRUE(test.proven_least);
    EXPECT_EQ(test.covered, 729U * 32U);
}

}  // namespace
}  // namespace grafverif
