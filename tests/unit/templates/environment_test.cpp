// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "library.hpp"

namespace grafverif {
namespace {

using Values = std::set<std::int64_t>;

/// The least and the greatest time, in units, for which `variable` has the value `from` between two changes, over all
/// runs. The search is limited to `horizon`; a greatest time of `horizon` represents any longer time.
struct Pace {
    std::int64_t least = 1000;
    std::int64_t greatest = 0;
};
Pace pace(const Network& network, const std::string& variable, std::int64_t from, std::int64_t horizon) {
    const NaiveTadd tadd(network);
    struct Run {
        TaddState state;
        std::int64_t since;
    };
    Pace result;
    std::set<std::pair<TaddState, std::int64_t>> seen;
    std::deque<Run> open{{tadd.initial(), -1}};  // -1: the run has had no change yet
    for (; !open.empty(); open.pop_front()) {
        const auto [state, since] = open.front();
        for (TaddMove& move : tadd.successors(state)) {
            std::int64_t age = since;
            if (move.delay() && since >= 0) age = std::min(since + 1, horizon);
            const std::int64_t before = tadd.variable(state, variable), after = tadd.variable(move.next, variable);
            if (before != after && before == from && since >= 0) {
                result.least = std::min(result.least, since);
                result.greatest = std::max(result.greatest, since);
            }
            if (before != after) age = 0;
            if (seen.emplace(move.next, age).second) open.push_back({std::move(move.next), age});
        }
    }
    return result;
}

TEST(PushButton, ChangesNoFasterThanItsGapAndMayStayForever) {
    const Network button = component_in_seconds("push_button", {{"GAP", 3000}});
    for (const std::int64_t from : {0, 1}) {
        const Pace found = pace(button, "OUT", from, 20);
        EXPECT_EQ(found.least, 3);
        EXPECT_EQ(found.greatest, 20);
    }
}

TEST(PushButtonReleased, IsReleasedInTimeAndMayStayReleasedForever) {
    const Network button = component_in_seconds("push_button_released", {{"GAP", 3000}, {"HOLD", 7000}});
    EXPECT_EQ(pace(button, "OUT", 0, 20).least, 3);
    EXPECT_EQ(pace(button, "OUT", 0, 20).greatest, 20);
    EXPECT_EQ(pace(button, "OUT", 1, 20).least, 3);
    EXPECT_EQ(pace(button, "OUT", 1, 20).greatest, 7);
}

TEST(PushButton, IsNotPressedBeforeItsGap) {
    Bench button = bench("push_button");
    EXPECT_EQ(button.values("OUT"), (Values{0}));
    button.wait(1);
    EXPECT_EQ(button.values("OUT"), (Values{0, 1}));
}

TEST(Switch2, ClosesExactlyOneContact) {
    const Network network = lone_component(library_component("switch_2"));
    const NaiveTadd tadd(network);
    const Reachable all = reachable(network, 1000);
    ASSERT_TRUE(all.complete);
    Values seen;
    for (const TaddState& state : all.states) {
        EXPECT_NE(tadd.variable(state, "FIRST"), tadd.variable(state, "SECOND"));
        seen.insert(tadd.variable(state, "SECOND"));
    }
    EXPECT_EQ(seen, (Values{0, 1}));
    const Network slow = component_in_seconds("switch_2", {{"GAP", 3000}});
    for (const std::int64_t from : {0, 1}) EXPECT_EQ(pace(slow, "FIRST", from, 9).least, 3);
    EXPECT_EQ(pace(slow, "FIRST", 1, 9).greatest, 9);
}

TEST(Free, ChangesWithinOneInstant) {
    const Network network = lone_component(library_component("free"));
    const Pace found = pace(network, "OUT", 1, 3);
    EXPECT_EQ(found.least, 0);
    EXPECT_EQ(found.greatest, 3);
}

TEST(FreeInteger, ReachesEveryValueOfItsRangeAndNoOther) {
    const Bench input = bench("free_integer", {{"LOW", -2}, {"HIGH", 2}});
    EXPECT_EQ(input.values("OUT"), (Values{-2, -1, 0, 1, 2}));
    const Network network = lone_component(library_component("free_integer"), {{"LOW", -2}, {"HIGH", 2}});
    const NaiveTadd tadd(network);
    for (const TaddState& state : reachable(network, 100).states) {
        Values next;
        for (const TaddMove& move : tadd.successors(state)) next.insert(tadd.variable(move.next, "OUT"));
        const std::int64_t value = tadd.variable(state, "OUT");
        EXPECT_EQ(next, (Values{std::max<std::int64_t>(value - 1, -2), value, std::min<std::int64_t>(value + 1, 2)}));
    }
}

}  // namespace
}  // namespace grafverif
