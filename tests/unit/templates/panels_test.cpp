// SPDX-License-Identifier: MIT
// Tests operator panels and guards: two-hand control, enabling switch, curtain, selectors, buttons, guard door.
#include <gtest/gtest.h>

#include "library.hpp"

namespace grafverif {
namespace {

using Values = std::set<std::int64_t>;

/// Returns the combinations of values of `outputs` over all reachable states.
std::set<std::vector<std::int64_t>> joint_values(const Network& network, const std::vector<std::string>& outputs) {
    const NaiveTadd tadd(network);
    const Reachable all = reachable(network, 100000);
    EXPECT_TRUE(all.complete && !all.out_of_range);
    std::set<std::vector<std::int64_t>> found;
    for (const TaddState& state : all.states) {
        std::vector<std::int64_t> values;
        for (const std::string& output : outputs) values.push_back(tadd.variable(state, output));
        found.insert(values);
    }
    return found;
}

/// Returns the reachable states of a single component. Each is paired with the time, in units up to `horizon`, for
/// which `variable` has had the value `value`, or with -1 if it has another value.
std::set<std::pair<TaddState, int>> aged(const Network& network, const std::string& variable, std::int64_t value,
                                         int horizon) {
    const NaiveTadd tadd(network);
    const auto age_of = [&](const TaddState& state, int age, bool delay) {
        if (tadd.variable(state, variable) != value) return -1;
        return std::min(horizon, age < 0 ? 0 : age + (delay ? 1 : 0));
    };
    std::vector<std::pair<TaddState, int>> open{{tadd.initial(), age_of(tadd.initial(), -1, false)}};
    std::set<std::pair<TaddState, int>> seen(open.begin(), open.end());
    while (!open.empty()) {
        const auto [state, age] = open.back();
        open.pop_back();
        for (const TaddMove& move : tadd.successors(state)) {
            const std::pair<TaddState, int> next{move.next, age_of(move.next, age, move.delay())};
            if (seen.insert(next).second) open.push_back(next);
        }
    }
    return seen;
}

TEST(TwoHandControl, IsValidOnlyIfBothButtonsArePressedWithinTheWindow) {
    const Network control = component_in_seconds("two_hand_control", {{"WINDOW", 3000}, {"GAP", 1000}});
    const NaiveTadd tadd(control);
    Values spreads;  // times from the left press to the rise of VALID
    for (const auto& [state, age] : aged(control, "LEFT", 1, 9))
        for (const TaddMove& move : tadd.successors(state))
            if (tadd.variable(state, "VALID") == 0 && tadd.variable(move.next, "VALID") == 1) spreads.insert(age);
    // -1 means that the right button is pressed first, or both simultaneously.
    EXPECT_EQ(spreads, (Values{-1, 1, 2, 3}));
}

TEST(TwoHandControl, IsValidAgainOnlyAfterBothButtonsWereReleased) {
    const Network control = component_in_seconds("two_hand_control", {{"WINDOW", 3000}, {"GAP", 1000}});
    const NaiveTadd tadd(control);
    for (const TaddState& state : reachable(control, 100000).states) {
        const bool refused = tadd.location(state, "it").starts_with("refused");
        for (const TaddMove& move : tadd.successors(state)) {
            if (!refused) continue;
            EXPECT_EQ(tadd.variable(move.next, "VALID"), 0);
            const bool pressed = tadd.variable(move.next, "LEFT") == 1 || tadd.variable(move.next, "RIGHT") == 1;
            EXPECT_EQ(tadd.location(move.next, "it").starts_with("refused"), pressed);
        }
    }
    EXPECT_EQ(joint_values(control, {"LEFT", "RIGHT", "VALID"}),
              (std::set<std::vector<std::int64_t>>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}));
}

TEST(EnablingSwitch, ReturnsFromPressedThroughWithoutEnabling) {
    const Network enabling = lone_component(library_component("enabling_switch"));
    const NaiveTadd tadd(enabling);
    EXPECT_EQ(joint_values(enabling, {"ENABLE", "PANIC"}),
              (std::set<std::vector<std::int64_t>>{{0, 0}, {1, 0}, {0, 1}}));
    for (const TaddState& state : reachable(enabling, 100).states)
        for (const TaddMove& move : tadd.successors(state))
            if (tadd.variable(state, "PANIC") == 1) {
                EXPECT_EQ(tadd.variable(move.next, "ENABLE"), 0);
            }
}

TEST(LightCurtain, DetectsEachBodyAfterItsResponse) {
    const Network curtain = component_in_seconds("light_curtain", {{"RESPONSE", 2000}, {"GAP", 3000}});
    const NaiveTadd tadd(curtain);
    Values delays;
    for (const auto& [state, age] : aged(curtain, "BODY", 1, 9))
        for (const TaddMove& move : tadd.successors(state)) {
            if (tadd.variable(state, "CLEAR") == 1 && tadd.variable(move.next, "CLEAR") == 0) delays.insert(age);
            EXPECT_TRUE(tadd.variable(move.next, "BODY") == 1 || tadd.variable(move.next, "CLEAR") == 1);
        }
    EXPECT_EQ(delays, (Values{2}));
}

TEST(KeySelectors, CloseOneContactAndTurnToNeighboursOnly) {
    const std::vector<std::string> contacts{"FIRST", "SECOND", "THIRD", "FOURTH"};
    for (const std::size_t positions : {3U, 4U}) {
        const std::vector<std::string> used(contacts.begin(),
                                            contacts.begin() + static_cast<std::ptrdiff_t>(positions));
        const Network key = lone_component(library_component("key_selector_" + std::to_string(positions)));
        const NaiveTadd tadd(key);
        const auto position = [&](const TaddState& state) {
            std::ptrdiff_t found = -1;
            for (std::size_t i = 0; i < positions; ++i)
                if (tadd.variable(state, used[i]) == 1) found = static_cast<std::ptrdiff_t>(i);
            return found;
        };
        EXPECT_EQ(joint_values(key, used).size(), positions);
        std::set<std::ptrdiff_t> turns;
        for (const TaddState& state : reachable(key, 100).states) {
            std::int64_t closed = 0;
            for (const std::string& contact : used) closed += tadd.variable(state, contact);
            EXPECT_EQ(closed, 1);
            for (const TaddMove& move : tadd.successors(state)) turns.insert(position(move.next) - position(state));
        }
        EXPECT_EQ(turns, (std::set<std::ptrdiff_t>{-1, 0, 1}));
    }
}

TEST(RotarySelector, TurnsThroughItsPositionsNoFasterThanItsGap) {
    Bench selector = bench("rotary_selector", {{"POSITIONS", 4}, {"START", 2}, {"GAP", 1000}});
    EXPECT_EQ(selector.values("POSITION"), (Values{2}));
    selector.wait(1);
    EXPECT_EQ(selector.values("POSITION"), (Values{1, 2, 3}));
    selector.wait(1);
    EXPECT_EQ(selector.values("POSITION"), (Values{1, 2, 3, 4}));
}

TEST(AcknowledgeButton, IsPressedInTimeOnRequestAndReleased) {
    const std::map<std::string, std::int64_t> times{
        {"REACTION", 2000}, {"PATIENCE", 4000}, {"GAP", 1000}, {"HOLD", 3000}};
    Bench button = bench("acknowledge_button", times);
    button.wait(20);
    EXPECT_EQ(only(button, "OUT"), 0);
    button.set("LAMP", 1);
    button.wait(1);
    EXPECT_EQ(only(button, "OUT"), 0);
    button.wait(1);
    EXPECT_EQ(button.values("OUT"), (Values{0, 1}));
    Bench late = bench("acknowledge_button", times);
    late.set("LAMP", 1);
    late.wait(3);
    late.set("LAMP", 0);
    late.wait(3);
    EXPECT_EQ(only(late, "OUT"), 0);  // the button is released within HOLD, or never pressed
    const Network alone = component_in_seconds("acknowledge_button", times);
    const NaiveTadd tadd(alone);
    for (const TaddState& state : reachable(alone, 1000).states) EXPECT_EQ(tadd.location(state, "it"), "idle");
}

TEST(EmergencyStop, LatchesAndIsPressedAtAnyTime) {
    Bench stop = bench("emergency_stop", {{"UNLATCH", 3000}});
    EXPECT_EQ(stop.values("OUT"), (Values{0, 1}));
    const Network latch = component_in_seconds("emergency_stop", {{"UNLATCH", 3000}});
    const NaiveTadd tadd(latch);
    Values held;
    for (const auto& [state, age] : aged(latch, "OUT", 1, 9))
        for (const TaddMove& move : tadd.successors(state))
            if (tadd.variable(state, "OUT") == 1 && tadd.variable(move.next, "OUT") == 0) held.insert(age);
    EXPECT_EQ(*held.begin(), 3);
    EXPECT_EQ(*held.rbegin(), 9);  // this is the horizon, because the button may remain pressed
}

TEST(EmergencyStop, OpensItsNormallyClosedContactWithThePress) {
    const Network closed = lone_component(library_component("emergency_stop"), {{"NORMALLY_CLOSED", 1}});
    const NaiveTadd tadd(closed);
    for (const TaddState& state : reachable(closed, 100).states)
        EXPECT_EQ(tadd.variable(state, "OUT"), tadd.location(state, "it") == "released" ? 1 : 0);
}

TEST(GuardDoor, StaysClosedWhileTheBoltIsIn) {
    Bench door = bench("guard_door", {{"BOLT", 2000}, {"GAP", 1000}});
    door.set("LOCK", 1);
    door.wait(1);
    EXPECT_EQ(door.values("CLOSED"), (Values{0, 1}));  // the door may open before the bolt is in
    EXPECT_EQ(door.values("LOCKED"), (Values{0}));
    door.wait(1);
    EXPECT_EQ(door.values("LOCKED"), (Values{0, 1}));
}

TEST(GuardDoor, OpensOnlyAfterTheBoltIsOut) {
    // With this GAP the door cannot open before the bolt is in.
    Bench door = bench("guard_door", {{"BOLT", 2000}, {"GAP", 9000}});
    door.set("LOCK", 1);
    door.wait(2);
    EXPECT_EQ(place_of(door), "locked");
    door.wait(20);
    EXPECT_EQ(place_of(door), "locked");
    EXPECT_EQ(only(door, "CLOSED"), 1);
    door.set("LOCK", 0);
    EXPECT_EQ(only(door, "LOCKED"), 0);
    door.wait(1);
    EXPECT_EQ(place_of(door), "unlocking");
    EXPECT_EQ(only(door, "CLOSED"), 1);
    door.wait(1);
    EXPECT_EQ(door.values("CLOSED"), (Values{0, 1}));
}

}  // namespace
}  // namespace grafverif
