// SPDX-License-Identifier: MIT
// Tests saturation with random event clusters, in comparison with steps executed one by one.
#include "bdd/saturation.hpp"

#include <gtest/gtest.h>

#include "support/random_chart.hpp"
#include "support/test_size.hpp"

namespace grafverif::bdd {
namespace {

constexpr std::uint32_t bits = 6;

/// An event cluster that may change one or two bits. The condition of the cluster reads two or
/// three bits and a choice, which is below all bits in the variable order.
struct Kind {
    std::vector<NextBit> next = {};
    Bdd condition = {};
};

std::uint32_t any_bit(Random& random) { return 2 * static_cast<std::uint32_t>(random_number(random, 0, bits - 1)); }

Kind random_kind(Random& random, const BddSpace& space) {
    const auto variable = [&] { return space.variable(chance(random, 30) ? 2 * bits : any_bit(random)); };
    Kind kind;
    kind.condition = variable() | ~variable();
    if (chance(random, 70)) kind.condition &= variable() ^ variable();
    for (std::int64_t count = random_number(random, 1, 2); count > 0; --count) {
        const std::uint32_t bit = any_bit(random);
        if (!kind.next.empty() && kind.next.front().before == bit) continue;
        kind.next.push_back({bit, chance(random, 50) ? ~space.variable(bit) : variable() & ~variable()});
    }
    return kind;
}

std::vector<bool> assignment(std::uint32_t state, bool chosen) {
    std::vector<bool> values(2 * bits + 1);
    for (std::uint32_t bit = 0; bit < bits; ++bit) values[2 * bit] = (state >> bit & 1U) != 0;
    values[2 * bits] = chosen;
    return values;
}

std::uint32_t after(const Kind& kind, std::uint32_t state, const std::vector<bool>& values) {
    for (const NextBit& bit : kind.next) {
        const std::uint32_t mask = 1U << (bit.before / 2);
        state = evaluate(bit.value, values) ? state | mask : state & ~mask;
    }
    return state;
}

std::vector<bool> reached(const std::vector<Kind>& kinds, std::uint32_t first) {
    std::vector<bool> found(1U << bits);
    std::vector<std::uint32_t> open{first};
    found[first] = true;
    while (!open.empty()) {
        const std::uint32_t state = open.back();
        open.pop_back();
        for (const Kind& kind : kinds)
            for (const bool chosen : {false, true}) {
                const std::vector<bool> values = assignment(state, chosen);
                if (!evaluate(kind.condition, values)) continue;
                const std::uint32_t next = after(kind, state, values);
                if (found[next]) continue;
                found[next] = true;
                open.push_back(next);
            }
    }
    return found;
}

TEST(Saturation, AgreesWithSingleSteps) {
    std::size_t states = 0;
    for (int seed = 1; seed <= test_size(200); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        BddSpace space;
        space.add_variables(2 * bits + 1);
        std::vector<Kind> kinds;
        std::deque<ClusterSteps> steps;
        for (std::int64_t count = random_number(random, 1, 6); count > 0; --count) {
            kinds.push_back(random_kind(random, space));
            steps.emplace_back(space, kinds.back().next, std::vector{kinds.back().condition},
                               std::vector<std::uint32_t>{2 * bits}, std::span<const std::uint32_t>{});
        }
        const auto first = static_cast<std::uint32_t>(random_number(random, 0, (1 << bits) - 1));
        std::vector<BddLiteral> literals;
        for (std::uint32_t bit = 0; bit < bits; ++bit) literals.push_back({2 * bit, (first >> bit & 1U) != 0});
        const Bdd found = Saturation(space, steps).closure(cube(space, literals));
        const std::vector<bool> expected = reached(kinds, first);
        for (std::uint32_t state = 0; state < 1U << bits; ++state) {
            ASSERT_EQ(evaluate(found, assignment(state, false)), expected[state]) << "seed " << seed << ": " << state;
            if (expected[state]) ++states;
        }
    }
    EXPECT_GT(states, 600u);
}

}  // namespace
}  // namespace grafverif::bdd
