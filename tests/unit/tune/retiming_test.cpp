// SPDX-License-Identifier: MIT
// Tests the transfer of runs between networks that differ in the constants of their clock constraints.
#include "run/retiming.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "ir/network_run.hpp"
#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

/// Returns a network of two processes: `a` moves to l1 at exactly `when`, and `b` at any time between `low` and `high`.
Network racing(std::int64_t when, std::int64_t low, std::int64_t high) {
    Sketch sketch;
    const auto a = sketch.process("a", 2, 1), b = sketch.process("b", 2, 1);
    sketch.invariant(a, 0, {0, Op::LessEqual, when});
    sketch.edge(a, {.from = 0, .to = 1, .when = {{0, Op::Equal, when}}});
    sketch.invariant(b, 0, {0, Op::LessEqual, high});
    sketch.edge(b, {.from = 0, .to = 1, .when = {{0, Op::GreaterEqual, low}}});
    sketch.property("first", Pattern::Reachable, {sketch.network.exprs.conjunction(sketch.at(a, 0), sketch.at(b, 1))});
    const FamilyMember member = member_of(sketch.network);
    return network_of(member.frame, member.constants);
}

Run run_of(const Network& network, const std::string& property) {
    const TimedResult result = checked(network);
    return verdict(result, property).run.value_or(Run{});
}

std::int64_t length_of(const Run& run) {
    std::int64_t sum = 0;
    for (const Move& move : run.moves)
        if (const auto* delay = std::get_if<Delay>(&move)) sum += delay->units;
    return sum;
}

TEST(Retiming, ChangesDelaysAsConstraintsRequire) {
    const Network from = racing(9, 2, 8);
    const grafverif::Run run = run_of(from, "first");
    EXPECT_EQ(length_of(run), 2);
    const Retiming retiming(from, run);
    for (std::int64_t low = 0; low <= 12; ++low) {
        const Network member = racing(9, low, 20);
        const auto fitted = retiming.fit(member);
        EXPECT_EQ(fitted.has_value(), low <= 9) << low;
        if (!fitted) continue;
        EXPECT_EQ(length_of(*fitted), low);
        EXPECT_TRUE(decides(member, *fitted, Pattern::Reachable));
    }
}

TEST(Retiming, RunsOfOtherNetworksAreRejected) {
    const Network from = racing(9, 2, 8);
    const grafverif::Run run = run_of(from, "first");
    EXPECT_FALSE(Retiming(racing(9, 5, 8), run).fit(from).has_value());
    EXPECT_FALSE(decides(racing(9, 5, 8), run, Pattern::Reachable));
}

/// Returns a network of a light that is initially off, is switched on after `first`, and then blinks with `period`.
Network blinking(std::int64_t first, std::int64_t period) {
    Sketch sketch;
    const auto light = sketch.process("light", 3, 1);
    sketch.invariant(light, 0, {0, Op::LessEqual, first});
    sketch.edge(light, {.from = 0, .to = 1, .when = {{0, Op::Equal, first}}, .reset = {0}});
    for (const std::uint32_t here : {1U, 2U}) {
        sketch.invariant(light, here, {0, Op::LessEqual, period});
        sketch.edge(light, {.from = here, .to = 3 - here, .when = {{0, Op::Equal, period}}, .reset = {0}});
    }
    sketch.property("off", Pattern::Inevitable, {sketch.network.exprs.constant(false)});
    const FamilyMember member = member_of(sketch.network);
    return network_of(member.frame, member.constants);
}

TEST(Retiming, LoopsAreRepeatable) {
    const Network from = blinking(2, 3);
    const grafverif::Run run = run_of(from, "off");
    ASSERT_TRUE(run.loop.has_value());
    const Retiming retiming(from, run);
    for (const auto& [first, period] : {std::pair<std::int64_t, std::int64_t>{5, 1}, {1, 7}}) {
        const Network member = blinking(first, period);
        const auto fitted = retiming.fit(member);
        ASSERT_TRUE(fitted.has_value());
        EXPECT_TRUE(decides(member, *fitted, Pattern::Inevitable));
    }
    EXPECT_FALSE(decides(from, run, Pattern::NoTimelock));
    EXPECT_FALSE(decides(from, run, Pattern::AlwaysPossible));
}

TEST(Retiming, ALoopThatCannotBeRepeatedDecidesNothing) {
    // The edge from l1 to l1 is possible only until c0 exceeds the bound, and c0 is never reset.
    const auto limited = [](std::int64_t bound) {
        Sketch sketch;
        const auto process = sketch.process("p", 2, 1);
        sketch.edge(process, {.from = 0, .to = 0, .when = {{0, Op::LessEqual, bound}}});
        return sketch.network;
    };
    const grafverif::Run loop{.moves = {Delay{1}, Fire{{0}, {0}}}, .loop = 0};
    EXPECT_FALSE(decides(expand(limited(5)), loop, Pattern::Inevitable));
    const grafverif::Run stay{.moves = {Delay{1}}, .loop = 0};
    EXPECT_TRUE(decides(expand(limited(5)), stay, Pattern::Inevitable));
}

/// Returns a network of one process that must leave l0 at `bound` at the latest, but can leave it only from `low` on.
Network gate(std::int64_t low, std::int64_t bound) {
    Sketch sketch;
    const auto process = sketch.process("door", 2, 1);
    sketch.invariant(process, 0, {0, Op::LessEqual, bound});
    sketch.edge(process, {.from = 0, .to = 1, .when = {{0, Op::GreaterEqual, low}}});
    sketch.property("time", Pattern::NoTimelock);
    sketch.property("opens", Pattern::Inevitable, {sketch.at(process, 1)});
    const FamilyMember member = member_of(sketch.network);
    return network_of(member.frame, member.constants);
}

TEST(Retiming, AnEndOfARunIsAnEndInTheOtherNetwork) {
    const Network from = gate(5, 2);
    for (const auto& [name, pattern] : {std::pair{"time", Pattern::NoTimelock}, {"opens", Pattern::Inevitable}}) {
        const Retiming retiming(from, run_of(from, name));
        for (std::int64_t bound = 1; bound <= 8; ++bound) {
            const Network member = gate(5, bound);
            const auto fitted = retiming.fit(member);
            ASSERT_TRUE(fitted.has_value());
            EXPECT_EQ(decides(member, *fitted, pattern), bound < 5) << name << bound;
        }
    }
}

TEST(Retiming, AStrictBoundDoesNotProveTheEndOfARun) {
    Sketch sketch;
    const auto process = sketch.process("p", 1, 1);
    sketch.invariant(process, 0, {0, Op::Less, 1});
    EXPECT_FALSE(decides(expand(sketch.network), grafverif::Run{}, Pattern::NoTimelock));
    Sketch closed;
    closed.invariant(closed.process("p", 1, 1), 0, {0, Op::LessEqual, 1});
    EXPECT_TRUE(decides(expand(closed.network), grafverif::Run{}, Pattern::NoTimelock));
}

}  // namespace
}  // namespace grafverif
