// SPDX-License-Identifier: MIT
// Tests the proof that evolutions end, on charts that show which premises the proof needs.
#include "check/inputs/evolutions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "check/inputs/resting.hpp"
#include "ir/junction.hpp"
#include "support/read_loop.hpp"

namespace grafverif {
namespace {

/// Returns a loop of a chart with the inputs A, B and the sensors IN, OUT of a cylinder, which Q extends.
Network with_chart(const std::string& body, Grain grain = Grain::Phased) {
    return expand(read_loop("grafcet c { input A, B, IN, OUT; output Q; internal M, N: int 0..3 = 0; " + body +
                                " }\nclosed_loop l { controller c; environment EA = push_button(OUT = A); "
                                "environment EB = push_button(OUT = B); "
                                "plant Cyl = cylinder_5_2_spring(G_OUT = Q, IN = IN, OUT = OUT); }\n",
                            {.grain = grain})
                      .network);
}

bool ends(const Network& network) {
    EXPECT_TRUE(lets_time_pass(network)) << "required by evolutions_end";
    return evolutions_end(network, abstractable_processes(network), {}).value();
}
bool ends(const std::string& body) {
    const bool phased = ends(with_chart(body));
    EXPECT_EQ(ends(with_chart(body, Grain::Atomic)), phased) << "the grain does not change the evolutions";
    return phased;
}

/// Returns a chart of two steps.
std::string two_steps(const std::string& forth, const std::string& back) {
    return "initial step 0; step 1; transition t0: 0 -> 1 when " + forth + "; transition t1: 1 -> 0 when " + back + ";";
}

TEST(EvolutionsEnd, IfNoInputsAdmitAllConditionsOfACycle) {
    EXPECT_TRUE(ends(two_steps("A", "!A")));
    EXPECT_TRUE(ends(two_steps("A && !B", "B")));
    EXPECT_FALSE(ends(two_steps("A", "B")));
    EXPECT_FALSE(ends(two_steps("true", "true")));
}

TEST(EvolutionsEnd, OnlyForReachableValuesOfInstances) {
    const std::string body = two_steps("IN", "OUT");
    EXPECT_TRUE(ends(body)) << "the cylinder is never in both end positions";
    const Network network = with_chart(body);
    EXPECT_FALSE(evolutions_end(network, {}, {}).value()) << "without its reachable values";
}

TEST(EvolutionsEnd, BecauseConstantInputsHaveNoEdges) {
    EXPECT_TRUE(ends(two_steps("rise(A)", "true")));
    EXPECT_TRUE(ends(two_steps("fall(A) && B", "true")));
    EXPECT_TRUE(
        ends("initial step 0; step 1; step 2; transition t0: 0 -> 1 when A; transition t1: 1 -> 2 when true; "
             "transition t2: 2 -> 0 when rise(B);"));
}

TEST(EvolutionsEnd, BecauseActivatedStepsRestartTheirTimers) {
    EXPECT_TRUE(ends(two_steps("1s/X0", "1s/X1")));
    EXPECT_TRUE(ends(two_steps("1s/X0", "true")));
}

TEST(EvolutionsEnd, OnlyIfTheControllerWaitsForItsTimers) {
    Network network = with_chart(two_steps("1s/X0", "1s/X1"));
    ASSERT_TRUE(ends(network));
    const Network::Controller& controller = network.controllers[{0}];
    Network::Template& plc = network.templates[network.processes[controller.process].automaton];
    const std::vector<TimerRequest> requests = requests_of(network);
    ASSERT_EQ(requests.size(), 2U);
    for (const Id<Network::Edge> id : plc.edges.ids()) {
        Network::Edge& edge = plc.edges[id];
        if (edge.from != controller.waiting) continue;
        std::vector<Id<Expr>> kept;
        for (const Id<Expr> conjunct : operands_of(network.exprs, edge.guard, Op::And)) {
            const bool waits = std::ranges::any_of(requests, [&](const TimerRequest& request) {
                return conjunct == network.exprs.negation(network.exprs.leaf(Op::Variable, request.request.index));
            });
            if (!waits) kept.push_back(conjunct);
        }
        edge.guard = network.exprs.conjunction(kept);
    }
    EXPECT_FALSE(ends(network)) << "the chart could continue before its timers restart";
}

TEST(EvolutionsEnd, WithForcingOrders) {
    const auto forced = [](const std::string& emergency) {
        return "partial S { initial step S0; step S1 { force P := {INIT}; } transition s0: S0 -> S1 when " + emergency +
               "; transition s1: S1 -> S0 when !B; } partial P { initial step 0; step 1; "
               "transition t0: 0 -> 1 when A; transition t1: 1 -> 0 when !A; }";
    };
    EXPECT_TRUE(ends(forced("B")));
    EXPECT_FALSE(ends(forced("A"))) << "S0 and S1 alternate for A && !B";
}

TEST(EvolutionsEnd, ForChartsThatReadEachOther) {
    const auto coupled = [](const std::string& answer) {
        return "partial L { initial step 0; step 1; transition t0: 0 -> 1 when X" + answer +
               "; transition t1: 1 -> 0 when !X" + answer +
               "; } partial R { initial step 2; step 3; transition t2: 2 "
               "-> 3 when A; transition t3: 3 -> 2 when !A; }";
    };
    EXPECT_TRUE(ends(coupled("3"))) << "R becomes stable first";
    EXPECT_FALSE(
        ends("partial L { initial step 0; step 1; transition t0: 0 -> 1 when X2; transition t1: 1 -> 0 when "
             "X3; } partial R { initial step 2; step 3; transition t2: 2 -> 3 when X1; transition t3: 3 -> 2 "
             "when X0; }"));
}

TEST(EvolutionsEnd, WithStoredValues) {
    EXPECT_TRUE(
        ends("initial step 0; step 1 { N := N + 1 on activation; } transition t0: 0 -> 1 when A && N < 3; "
             "transition t1: 1 -> 0 when !A do N := 0;"));
    EXPECT_TRUE(
        ends("initial step 0; step 1 { M := !M on activation; } transition t0: 0 -> 1 when A; transition t1: 1 "
             "-> 0 when !A;"));
    EXPECT_FALSE(
        ends("initial step 0; step 1 { M := !M on activation; } transition t0: 0 -> 1 when A; transition t1: "
             "1 -> 0 when true;"));
}

TEST(EvolutionsEnd, OnlyWithoutModelErrors) {
    EXPECT_FALSE(
        ends("initial step 0; step 1 { N := N + 1 on activation; } transition t0: 0 -> 1 when A; "
             "transition t1: 1 -> 0 when !A;"));
    EXPECT_FALSE(
        ends("partial L { initial step 0; step 1 { M := true on activation; } transition t0: 0 -> 1 when A; "
             "transition t1: 1 -> 0 when !A; } partial R { initial step 2; step 3 { M := false on activation; } "
             "transition t2: 2 -> 3 when B; transition t3: 3 -> 2 when !B; }"))
        << "both actions can write M in one evolution";
}

TEST(EvolutionsEnd, OnlyIfACycleReadsEachInputOnce) {
    Network network = with_chart(two_steps("A", "!A"));
    ASSERT_TRUE(ends(network));
    const auto named = [&](const std::string& name) {
        const auto at = std::ranges::find(network.variables, name, &Network::Variable::name);
        return network.exprs.leaf(Op::Variable, static_cast<std::uint32_t>(at - network.variables.begin()));
    };
    const Network::Controller& controller = network.controllers[{0}];
    Network::Template& plc = network.templates[network.processes[controller.process].automaton];
    for (const Id<Network::Edge> id : plc.edges.ids())
        if (has_call(plc.edges[id], controller.evolve)) plc.edges[id].assignments.push_back({named("M"), named("A")});
    EXPECT_FALSE(ends(network)) << "A may change between two edges of the cycle";
}

TEST(EvolutionsEnd, OfControllersThatReadEachOther) {
    const Network network =
        expand(read_loop("grafcet c { input A; output Q; initial step 0; step 1 { Q; } transition t0: 0 -> 1 when A; "
                         "transition t1: 1 -> 0 when !A; }\n"
                         "grafcet d { input Q; output R; initial step 0; step 1 { R; } transition t0: 0 -> 1 when Q; "
                         "transition t1: 1 -> 0 when !Q; }\n"
                         "closed_loop l { controller c; controller d; environment EA = push_button(OUT = A); }\n")
                   .network);
    EXPECT_TRUE(evolutions_end(network, abstractable_processes(network), {}).value()) << "c does not depend on d";
    const std::string feedback =
        "grafcet c { input R; output Q; initial step 0; step 1 { Q; } transition t0: 0 -> 1 when !R; transition t1: 1 "
        "-> 0 when R; }\n"
        "grafcet d { input Q; output R; initial step 0; step 1 { R; } transition t0: 0 -> 1 when Q; transition t1: 1 "
        "-> "
        "0 when !Q; }\n"
        "closed_loop l { controller c; controller d; }\n";
    const Network coupled = expand(read_loop(feedback).network);
    EXPECT_FALSE(evolutions_end(coupled, abstractable_processes(coupled), {}).value()) << "the controllers alternate";
}

TEST(EvolutionsEnd, OfTheStations) {
    for (const char* name : {"kettle", "lift", "press", "undecided/capper", "undecided/carwash", "undecided/paintbooth",
                             "undecided/washer"})
        EXPECT_TRUE(ends(expand(read_sample("../bench/stations/" + std::string(name) + ".grafcet").network))) << name;
}

}  // namespace
}  // namespace grafverif
