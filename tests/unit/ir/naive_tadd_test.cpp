// SPDX-License-Identifier: MIT
// Tests the reference semantics on the small examples of CEP13 section 2. Other tests compare engines, emitters and
// library components with these semantics.
#include "support/naive_tadd.hpp"

#include <gtest/gtest.h>

namespace grafverif {
namespace {

/// Returns the network of CEP13 Fig. 4: A -> B urgent, A -> C sets a; 1 -> 2 at T = 2, 1 -> 3 when a; invariant of 1: T
/// <= 2.
Network figure_4() {
    Network network;
    const auto a = network.variables.add({.name = "a"});
    const Id<Expr> is_a = network.exprs.leaf(Op::Variable, a.index), always = network.exprs.constant(true);
    Network::Template left{.name = "left"};
    const auto A = left.locations.add({.name = "A"}), B = left.locations.add({.name = "B"}),
               C = left.locations.add({.name = "C"});
    left.initial = A;
    left.edges.add({.from = A, .to = B, .urgent = true, .guard = always});
    left.edges.add({.from = A, .to = C, .guard = always, .assignments = {{is_a, always}}});
    Network::Template right{.name = "right"};
    const auto T = right.clocks.add({"T"});
    const auto one = right.locations.add({.name = "1", .invariant = {{T, Op::LessEqual, network.exprs.integer(2)}}});
    const auto two = right.locations.add({.name = "2"}), three = right.locations.add({.name = "3"});
    right.initial = one;
    right.edges.add({.from = one,
                     .to = two,
                     .guard = always,
                     .constraint = {{T, Op::Equal, network.exprs.integer(2)}},
                     .resets = {T}});
    right.edges.add({.from = one, .to = three, .guard = is_a});
    network.processes.add({.name = "L", .automaton = network.templates.add(std::move(left)), .initial = A});
    network.processes.add({.name = "R", .automaton = network.templates.add(std::move(right)), .initial = one});
    return network;
}

TEST(NaiveTadd, AnUrgentEdgeForbidsTimeToPassAndOtherEdgesMayStillFire) {
    const Network network = figure_4();
    const NaiveTadd tadd(network);
    const std::vector<TaddMove> moves = tadd.successors(tadd.initial());
    ASSERT_EQ(moves.size(), 2U);
    EXPECT_EQ(tadd.location(moves[0].next, "L"), "B");
    EXPECT_EQ(tadd.location(moves[1].next, "L"), "C");
    EXPECT_EQ(tadd.variable(moves[1].next, "a"), 1);
}

TEST(NaiveTadd, AnInvariantForcesAnEdgeWhenItsTimeHasCome) {
    const Network network = figure_4();
    const NaiveTadd tadd(network);
    TaddState state = tadd.successors(tadd.initial())[1].next;  // the locations are (C, 1), and a is true
    for (int unit = 0; unit < 2; ++unit) {
        const std::vector<TaddMove> moves = tadd.successors(state);
        ASSERT_EQ(moves.size(), 2U) << "1 -> 3, or wait";
        ASSERT_TRUE(moves.back().delay());
        state = moves.back().next;
    }
    const std::vector<TaddMove> moves = tadd.successors(state);
    ASSERT_EQ(moves.size(), 2U) << "1 -> 2 or 1 -> 3: location 1 cannot remain active";
    EXPECT_EQ(tadd.location(moves[0].next, "R"), "2");
    EXPECT_EQ(tadd.location(moves[1].next, "R"), "3");
}

TEST(NaiveTadd, TheTargetInvariantOfAnUrgentEdgeIsTestedAfterItsResets) {
    Network network = figure_4();
    Network::Template& right = network.templates[{1}];
    right.locations[{2}].invariant = {{{0}, Op::LessEqual, network.exprs.integer(0)}};
    right.edges[{1}].urgent = true;
    right.edges[{1}].resets = {{0}};
    const NaiveTadd tadd(network);
    TaddState state = tadd.successors(tadd.initial())[1].next;  // the locations are (C, 1), and a is true
    state.clocks[0] = 1;
    EXPECT_TRUE(tadd.urgent_enabled(state)) << "equations (7) and (9) as printed would let time pass here";
}

TEST(NaiveTadd, ClocksStopOneAboveTheLargestConstant) {
    const Network network = figure_4();
    const Reachable all = reachable(network, 1000);
    EXPECT_TRUE(all.complete);
    for (const TaddState& state : all.states) EXPECT_LE(state.clocks[0], 3);
}

TEST(NaiveTadd, AValueOutsideItsRangeIsReported) {
    Network network = figure_4();
    network.variables.add({.name = "n", .type = integer_type(0, 1)});
    const Id<Expr> n = network.exprs.leaf(Op::Variable, 1);
    network.templates[{0}].edges[{1}].assignments = {{n, network.exprs.integer(2)}};
    const NaiveTadd tadd(network);
    EXPECT_TRUE(tadd.successors(tadd.initial())[1].out_of_range);
    EXPECT_TRUE(reachable(network, 1000).out_of_range);
}

TEST(NaiveTadd, AssignmentsRunInOrderAndProceduresAfterThem) {
    Network network = figure_4();
    network.variables.add({.name = "n", .type = integer_type(0, 9)});
    const Id<Expr> n = network.exprs.leaf(Op::Variable, 1);
    Network::Template& left = network.templates[{0}];
    left.procedures.add({"twice", {{n, network.exprs.apply(Op::Times, n, network.exprs.integer(2))}}});
    left.edges[{0}].assignments = {{n, network.exprs.integer(3)},
                                   {n, network.exprs.apply(Op::Plus, n, network.exprs.integer(1))}};
    left.edges[{0}].calls = {{0}};
    const NaiveTadd tadd(network);
    EXPECT_EQ(tadd.variable(tadd.successors(tadd.initial())[0].next, "n"), 8);
}

}  // namespace
}  // namespace grafverif
