// SPDX-License-Identifier: MIT
#include "conform/tour.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <random>
#include <set>

#include "support/test_size.hpp"

namespace grafverif::conform {
namespace {

using Random = std::mt19937_64;

TourArc arc(std::uint32_t from, std::uint32_t to) {
    TourArc result;
    result.from = from, result.to = to;
    return result;
}

/// Returns the least number of arcs of a tour that covers all arcs, found by exhaustive search. If `restarts`, the tour
/// may consist of several sequences.
std::uint64_t tried_length(std::uint32_t start, const std::vector<TourArc>& arcs, bool restarts) {
    using Situation = std::pair<std::uint32_t, std::uint32_t>;  // pair of the current node and the set of covered arcs
    std::map<Situation, std::uint64_t> length{{{start, 0}, 0}};
    std::deque<Situation> open{{start, 0}};
    const std::uint32_t all = (1U << arcs.size()) - 1;
    const auto reach = [&](Situation next, std::uint64_t steps, bool free) {
        const auto [place, added] = length.try_emplace(next, steps);
        if (!added && place->second <= steps) return;
        place->second = steps;
        free ? open.push_front(next) : open.push_back(next);
    };
    while (!open.empty()) {
        const Situation now = open.front();
        open.pop_front();
        const std::uint64_t steps = length.at(now);
        if (now.second == all) return steps;
        if (restarts) reach({start, now.second}, steps, true);
        for (std::uint32_t k = 0; k < arcs.size(); ++k)
            if (arcs[k].from == now.first) reach({arcs[k].to, now.second | (1U << k)}, steps + 1, false);
    }
    return 0;
}

/// Returns a few arcs that are all reachable from node 0.
std::vector<TourArc> random_arcs(Random& random, std::uint32_t nodes) {
    std::vector<TourArc> arcs;
    std::vector<std::uint32_t> reached{0};
    const std::size_t count = 2 + random() % 7;
    while (arcs.size() < count) {
        const std::uint32_t from = reached[random() % reached.size()],
                            to = static_cast<std::uint32_t>(random() % nodes);
        arcs.push_back(arc(from, to));
        if (std::ranges::find(reached, to) == reached.end()) reached.push_back(to);
    }
    return arcs;
}

/// Numbers the nodes consecutively.
std::uint32_t renumbered(std::vector<TourArc>& arcs) {
    std::map<std::uint32_t, std::uint32_t> number{{0, 0}};
    for (TourArc& one : arcs)
        for (std::uint32_t* node : {&one.from, &one.to})
            *node = number.emplace(*node, static_cast<std::uint32_t>(number.size())).first->second;
    return static_cast<std::uint32_t>(number.size());
}

bool strongly_connected(std::uint32_t nodes, const std::vector<TourArc>& arcs) {
    for (std::uint32_t start = 0; start < nodes; ++start) {
        std::set<std::uint32_t> seen{start};
        for (std::size_t round = 0; round < nodes; ++round)
            for (const TourArc& one : arcs)
                if (seen.contains(one.from)) seen.insert(one.to);
        if (seen.size() < nodes) return false;
    }
    return true;
}

void expect_a_tour(const Tour& tour, const std::vector<TourArc>& arcs) {
    std::set<std::uint32_t> crossed;
    std::uint64_t length = 0;
    for (const auto& sequence : tour.sequences) {
        std::uint32_t node = 0;
        for (const std::uint32_t index : sequence) {
            ASSERT_EQ(arcs[index].from, node);
            node = arcs[index].to;
            crossed.insert(index);
            ++length;
        }
    }
    EXPECT_EQ(crossed.size(), arcs.size());
    EXPECT_EQ(length, tour.length);
}

TEST(Tour, IsAsShortAsAnExhaustiveSearchFinds) {
    int one = 0, several = 0;
    for (int seed = 1; seed <= test_size(300); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        std::vector<TourArc> arcs = random_arcs(random, 2 + static_cast<std::uint32_t>(random() % 4));
        const std::uint32_t nodes = renumbered(arcs);
        const bool connected = strongly_connected(nodes, arcs);
        ++(connected ? one : several);
        const Tour tour = least_tour(nodes, 0, arcs);
        expect_a_tour(tour, arcs);
        EXPECT_EQ(tour.length, tried_length(0, arcs, !connected));
        if (connected) {
            EXPECT_EQ(tour.sequences.size(), 1U);
        }
    }
    EXPECT_GT(one, 20);
    EXPECT_GT(several, 20);
}

TEST(Tour, OfAnEulerianGraphCrossesEachArcOnce) {
    const std::vector<TourArc> arcs{arc(0, 1), arc(1, 2), arc(2, 0), arc(0, 2), arc(2, 1), arc(1, 0)};
    const Tour tour = least_tour(3, 0, arcs);
    expect_a_tour(tour, arcs);
    EXPECT_EQ(tour.length, 6U);
}

TEST(Tour, HasAsFewSequencesAsItsLengthAllows) {
    const std::vector<TourArc> arcs{arc(0, 1), arc(0, 2), arc(0, 3), arc(3, 0)};
    const Tour tour = least_tour(4, 0, arcs);
    expect_a_tour(tour, arcs);
    EXPECT_EQ(tour.length, 4U);
    EXPECT_EQ(tour.sequences.size(), 2U);
}

TEST(VisitingTour, VisitsEveryNodeThatAnArcEnters) {
    for (int seed = 1; seed <= test_size(100); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        std::vector<TourArc> arcs = random_arcs(random, 6);
        const std::uint32_t nodes = renumbered(arcs);
        std::set<std::uint32_t> wanted, seen;
        for (const TourArc& one : arcs) wanted.insert(one.to);
        for (const auto& sequence : visiting_tour(nodes, 0, arcs).sequences) {
            std::uint32_t node = 0;
            for (const std::uint32_t index : sequence) {
                ASSERT_EQ(arcs[index].from, node);
                seen.insert(node = arcs[index].to);
            }
        }
        EXPECT_EQ(seen, wanted) << seed;
    }
}

}  // namespace
}  // namespace grafverif::conform
