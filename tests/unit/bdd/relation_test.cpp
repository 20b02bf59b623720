// SPDX-License-Identifier: MIT
// Tests images, preimages and rings under random steps, in comparison with steps executed one by one.
#include "bdd/relation.hpp"

#include <gtest/gtest.h>

#include "bdd/rings.hpp"
#include "support/random_chart.hpp"
#include "support/test_size.hpp"

namespace grafverif::bdd {
namespace {

/// Random steps. The bits of a state are the variables 0, 2, 4, ..., each followed by its next value; the choices are
/// below them in the variable order.
struct RandomSteps {
    static constexpr std::uint32_t bits = 4, choices = 2, choice = 2 * bits;
    BddSpace space = BddSpace();
    std::vector<NextBit> next = {};
    Bdd offered = {};
    std::vector<std::uint32_t> before = {}, choosing = {}, all = {};

    explicit RandomSteps(Random& random) {
        space.add_variables(2 * bits + choices);
        for (std::uint32_t bit = 0; bit < bits; ++bit) before.push_back(2 * bit);
        for (std::uint32_t k = 0; k < choices; ++k) choosing.push_back(choice + k);
        all = before;
        all.insert(all.end(), choosing.begin(), choosing.end());
        for (std::uint32_t bit = bits; bit-- > 0;) next.push_back({2 * bit, function(random, all)});
        offered = function(random, all) | space.variable(choice);
    }

    Bdd function(Random& random, const std::vector<std::uint32_t>& of) {
        Bdd result = Bdd::constant(chance(random, 50));
        for (int k = 0; k < 6; ++k) {
            const Bdd one = space.variable(
                of[static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(of.size()) - 1))]);
            result = chance(random, 50) ? result ^ one : chance(random, 50) ? result & one : result | one;
        }
        return result;
    }

    std::vector<bool> assignment(std::uint32_t state, std::uint32_t chosen) const {
        std::vector<bool> values(space.variables());
        for (std::uint32_t bit = 0; bit < bits; ++bit) values[2 * bit] = (state >> bit & 1U) != 0;
        for (std::uint32_t k = 0; k < choices; ++k) values[choice + k] = (chosen >> k & 1U) != 0;
        return values;
    }

    std::uint32_t after(const std::vector<bool>& values) const {
        std::uint32_t state = 0;
        for (const NextBit& bit : next)
            if (evaluate(bit.value, values)) state |= 1U << (bit.before / 2);
        return state;
    }

    template <class Visit>
    void for_each(const Visit& visit) const {
        for (std::uint32_t state = 0; state < 1U << bits; ++state)
            for (std::uint32_t chosen = 0; chosen < 1U << choices; ++chosen)
                visit(state, chosen, assignment(state, chosen));
    }
};

TEST(Relation, ImagesAgreeWithSingleSteps) {
    for (int seed = 1; seed <= test_size(200); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        RandomSteps steps(random);
        const Relation relation(steps.space, steps.next, {steps.offered}, steps.choosing);
        const Bdd from = steps.function(random, steps.before), to = steps.function(random, steps.before);
        std::vector<bool> led(1U << RandomSteps::bits);
        steps.for_each([&](std::uint32_t, std::uint32_t, const std::vector<bool>& values) {
            if (evaluate(from & steps.offered, values)) led[steps.after(values)] = true;
        });
        const Bdd image = relation.image(from, relation.quantified(steps.before)), preimage = relation.preimage(to);
        const Relation kept(steps.space, steps.next);  // this relation still depends on the choice
        const Bdd chosen = kept.image(from & steps.offered, kept.quantified(steps.before));
        std::vector<bool> leads(1U << RandomSteps::bits);
        steps.for_each([&](std::uint32_t state, std::uint32_t, const std::vector<bool>& values) {
            if (evaluate(steps.offered, values) && evaluate(to, steps.assignment(steps.after(values), 0)))
                leads[state] = true;
        });
        steps.for_each([&](std::uint32_t state, std::uint32_t choice, const std::vector<bool>& values) {
            EXPECT_EQ(evaluate(image, values), led[state]) << "seed " << seed;
            EXPECT_EQ(evaluate(preimage, values), leads[state]) << "seed " << seed;
            bool chosen_leads = false;  // true if a step with `choice` leads to `state`
            for (std::uint32_t origin = 0; origin < 1U << RandomSteps::bits; ++origin) {
                const std::vector<bool> there = steps.assignment(origin, choice);
                chosen_leads = chosen_leads || (evaluate(from & steps.offered, there) && steps.after(there) == state);
            }
            EXPECT_EQ(evaluate(chosen, values), chosen_leads) << "seed " << seed;
        });
    }
}

/// Returns the distance from `first` for each state; -1 if a state is unreachable.
std::vector<int> distances(const RandomSteps& steps, std::uint32_t first) {
    std::vector<int> distance(1U << RandomSteps::bits, -1);
    distance[first] = 0;
    for (int round = 0; round < 1 << RandomSteps::bits; ++round)
        steps.for_each([&](std::uint32_t state, std::uint32_t, const std::vector<bool>& values) {
            int& next = distance[steps.after(values)];
            if (distance[state] == round && evaluate(steps.offered, values) && next < 0) next = round + 1;
        });
    return distance;
}

TEST(Rings, HoldTheStatesByTheirDistanceAndShortestPathsLeadBackThroughThem) {
    for (int seed = 1; seed <= test_size(200); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        RandomSteps steps(random);
        const Relation relation(steps.space, steps.next, {steps.offered}, steps.choosing);
        const Relation::Quantified all = relation.quantified(steps.before);
        const auto only = [&](std::uint32_t state) {
            std::vector<BddLiteral> literals;
            for (std::uint32_t bit = 0; bit < RandomSteps::bits; ++bit)
                literals.push_back({2 * bit, (state >> bit & 1U) != 0});
            return cube(steps.space, literals);
        };
        Rings rings;
        EXPECT_FALSE(rings.add(Bdd{}));
        EXPECT_EQ(rings.nearest(Bdd::constant(true)), std::nullopt);
        for (bool found = rings.add(only(0)); found;) found = rings.add(relation.image(rings.each.back(), all));
        const std::vector<int> distance = distances(steps, 0);
        for (std::uint32_t state = 0; state < 1U << RandomSteps::bits; ++state) {
            const std::optional<std::size_t> ring = rings.nearest(only(state));
            ASSERT_EQ(ring ? static_cast<int>(*ring) : -1, distance[state]) << state;
            if (!ring) continue;
            const std::vector<std::uint32_t> path =
                path_back(*ring, state, [&](std::size_t before, std::uint32_t next) {
                    const Bdd found = rings.each[before] & relation.preimage(only(next));
                    std::uint32_t origin = 0;
                    while ((found & only(origin)).is_false()) ++origin;
                    return origin;
                });
            ASSERT_EQ(path.size(), *ring + 1);
            for (std::size_t k = 0; k < path.size(); ++k) EXPECT_EQ(distance[path[k]], static_cast<int>(k));
        }
    }
}

}  // namespace
}  // namespace grafverif::bdd
