// SPDX-License-Identifier: MIT
// Tests relaxations of networks that differ in the constants of their clock constraints. Each premise of a transfer is
// violated once: the relaxation satisfies the property, a member violates the property, and the premise is false.
#include "ir/network_family.hpp"

#include <gtest/gtest.h>

#include "unit/check/networks.hpp"

namespace grafverif {
namespace {

/// Returns a network of one process, which leaves l0 at `c0 >= low`; the invariant of l0 is `c0 <= high`. In l1,
/// nothing happens.
Network door(std::int64_t low, std::int64_t high, Op relation = Op::GreaterEqual) {
    Sketch sketch;
    const auto process = sketch.process("door", 2, 1);
    sketch.invariant(process, 0, {0, Op::LessEqual, high});
    sketch.edge(process, {.from = 0, .to = 1, .when = {{0, relation, low}}});
    sketch.property("time", Pattern::NoTimelock);
    sketch.property("opens", Pattern::Inevitable, {sketch.at(process, 1)});
    sketch.property("stays", Pattern::Always, {sketch.at(process, 0)});
    return sketch.network;
}

/// Returns the relaxation of two networks of one family.
Network relaxed(const Network& a, const Network& b) {
    const FamilyMember one = member_of(a), other = member_of(b);
    EXPECT_EQ(one.frame, other.frame);
    EXPECT_EQ(hash_of(one.frame), hash_of(other.frame));
    Network made = network_of(one.frame, relaxation_of(one.frame, {&one.constants, &other.constants}));
    EXPECT_EQ(verify(made), std::vector<std::string>{});
    return made;
}

Network split(const Network& network) {
    const FamilyMember member = member_of(network);
    return network_of(member.frame, member.constants);
}

TEST(NetworkFamily, AMemberIsItsNetwork) {
    const Network network = door(2, 3);
    EXPECT_EQ(member_of(network).constants, (ClockConstants{3, 2}));
    EXPECT_EQ(expand(network), expand(split(network)));
}

TEST(NetworkFamily, RelaxationUsesTheGreatestUpperAndTheLeastLowerBounds) {
    EXPECT_EQ(expand(relaxed(door(2, 3), door(1, 7))), expand(split(door(1, 7))));
    EXPECT_EQ(expand(relaxed(door(1, 3), door(2, 7))), expand(split(door(1, 7))));
}

TEST(NetworkFamily, EqualityBecomesAnInterval) {
    const Network made = relaxed(door(2, 9, Op::Equal), door(5, 9, Op::Equal));
    const auto& constraint = made.templates[made.processes[Id<Network::Process>{0}].automaton].edges[{0}].constraint;
    ASSERT_EQ(constraint.size(), 2U);
    EXPECT_EQ(admitted(made, constraint[0]).low, 2);
    EXPECT_EQ(admitted(made, constraint[1]).high, 5);
}

TEST(NetworkFamily, FramesDifferIfMoreThanConstantsOfClockConstraintsDiffers) {
    EXPECT_NE(member_of(door(2, 3)).frame, member_of(door(2, 3, Op::Equal)).frame);
    Network other = door(2, 3);
    other.time_unit_ms = 1;
    EXPECT_NE(member_of(door(2, 3)).frame, member_of(other).frame);
    Network property = door(2, 3);
    property.properties[Id<Property>{2}].pattern = Pattern::Never;
    const Network one = member_of(door(2, 3)).frame, two = member_of(property).frame;
    EXPECT_NE(one, two);
    EXPECT_EQ(with_only(one, "time"), with_only(two, "time"));
    EXPECT_NE(with_only(one, "stays"), with_only(two, "stays"));
}

TEST(NetworkFamily, ConstantsThatAreEqualByChanceDoNotChangeTheFrame) {
    const auto counting = [](std::int64_t high) {
        Sketch sketch;
        const auto process = sketch.process("p", 1, 1);
        const auto n = sketch.integer("n", 0, 5);
        sketch.invariant(process, 0, {0, Op::LessEqual, high});
        sketch.edge(process, {.from = 0,
                              .to = 0,
                              .guard = sketch.op(Op::Less, sketch.is(n), sketch.number(4)),
                              .when = {{0, Op::Equal, high}},
                              .set = {{n, sketch.number(3)}},
                              .reset = {0}});
        return member_of(sketch.network);
    };
    for (const std::int64_t high : {1, 3, 4, 9}) EXPECT_EQ(counting(high).frame, counting(2).frame) << high;
}

TEST(NetworkFamily, NoTimelockNeedsThatEdgesReleaseTheBoundsOfTheMember) {
    const Network good = door(3, 5), stuck = door(3, 1), all = relaxed(good, stuck);
    EXPECT_EQ(outcome_text(checked(all), "time"), "holds");
    EXPECT_EQ(outcome_text(checked(stuck), "time"), "violated");
    EXPECT_FALSE(ClockFacts(split(stuck)).releases_bounds_of(ClockFacts(all)));
    EXPECT_TRUE(ClockFacts(split(good)).releases_bounds_of(ClockFacts(all)));
}

TEST(NetworkFamily, NoTimelockNeedsPositiveBounds) {
    const auto beating = [](std::int64_t period) {
        Sketch sketch;
        const auto process = sketch.process("p", 1, 1);
        sketch.invariant(process, 0, {0, Op::LessEqual, period});
        sketch.edge(process, {.from = 0, .to = 0, .when = {{0, Op::Equal, period}}, .reset = {0}});
        sketch.property("time", Pattern::NoTimelock);
        return sketch.network;
    };
    const Network good = beating(4), stuck = beating(0), all = relaxed(good, stuck);
    EXPECT_EQ(outcome_text(checked(all), "time"), "holds");
    EXPECT_EQ(outcome_text(checked(stuck), "time"), "violated");
    EXPECT_FALSE(ClockFacts(split(stuck)).releases_bounds_of(ClockFacts(all)));
    EXPECT_TRUE(ClockFacts(split(good)).releases_bounds_of(ClockFacts(all)));
}

TEST(NetworkFamily, LivenessNeedsThatTimePassesInTheMember) {
    const Network stuck = door(3, 1), all = relaxed(door(3, 5), stuck);
    EXPECT_EQ(outcome_text(checked(all), "opens"), "holds");
    EXPECT_EQ(outcome_text(checked(stuck), "opens"), "violated");
    EXPECT_EQ(outcome_text(checked(stuck), "time"), "violated");
}

TEST(NetworkFamily, NoDeadlockNeedsThatEdgesRemainPossible) {
    const auto leaving = [](std::int64_t bound) {
        Sketch sketch;
        const auto process = sketch.process("p", 2, 1);
        sketch.invariant(process, 1, {0, Op::LessEqual, bound});
        sketch.edge(process, {.from = 0, .to = 1, .reset = {0}});
        sketch.edge(process, {.from = 1, .to = 0});
        sketch.property("moves", Pattern::NoDeadlock);
        sketch.property("time", Pattern::NoTimelock);
        return sketch.network;
    };
    const Network good = leaving(4), stuck = leaving(-1), all = relaxed(good, stuck);
    EXPECT_EQ(outcome_text(checked(all), "moves"), "holds");
    EXPECT_EQ(outcome_text(checked(stuck), "time"), "holds");
    EXPECT_EQ(outcome_text(checked(stuck), "moves"), "violated");
    EXPECT_FALSE(ClockFacts(split(stuck)).keeps_edges_of(ClockFacts(all)));
    EXPECT_TRUE(ClockFacts(split(good)).keeps_edges_of(ClockFacts(all)));
}

}  // namespace
}  // namespace grafverif
