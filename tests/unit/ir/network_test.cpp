// SPDX-License-Identifier: MIT
#include "grafverif/ir/network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "support/naive_tadd.hpp"
#include "support/print_network.hpp"
#include "support/random_network.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

/// Returns one template with a parameter of each kind and a clock, and one process of that template.
Network small_network() {
    Network network;
    const auto go = network.variables.add({.name = "go"});
    const auto level = network.variables.add({.name = "level", .type = integer_type(0, 3)});
    Network::Template mover{.name = "mover"};
    mover.parameters.add({"G", Network::ParameterKind::Read, {}});
    mover.parameters.add({"X", Network::ParameterKind::Written, integer_type(0, 3)});
    mover.parameters.add({"D", Network::ParameterKind::Constant, integer_type(0, 100)});
    const Id<Expr> order = network.exprs.leaf(Op::Parameter, 0), position = network.exprs.leaf(Op::Parameter, 1);
    const Id<Expr> duration = network.exprs.leaf(Op::Parameter, 2);
    const auto t = mover.clocks.add({"t"});
    const auto still = mover.locations.add({.name = "still"});
    const auto moving = mover.locations.add({.name = "moving", .invariant = {{t, Op::LessEqual, duration}}});
    mover.initial = still;
    mover.edges.add({.from = still, .to = moving, .urgent = true, .guard = order, .resets = {t}});
    mover.edges.add({.from = moving,
                     .to = still,
                     .guard = network.exprs.apply(Op::Less, position, network.exprs.integer(3)),
                     .constraint = {{t, Op::Equal, duration}},
                     .assignments = {{position, network.exprs.apply(Op::Plus, position, network.exprs.integer(1))}}});
    const auto automaton = network.templates.add(std::move(mover));
    network.processes.add(
        {.name = "Mover", .automaton = automaton, .arguments = {go, level, std::int64_t{2}}, .initial = still});
    return network;
}

TEST(Network, AWellFormedNetworkHasNoFaults) { EXPECT_EQ(verify(small_network()), std::vector<std::string>{}); }

TEST(Network, EachBrokenInvariantIsNamed) {
    struct Case {
        const char* expected;
        std::function<void(Network&)> damage;
    };
    const auto edge = [](Network& network, std::uint32_t k) -> Network::Edge& {
        return network.templates[{0}].edges[{k}];
    };
    const std::vector<Case> cases{
        {"variable go: its initial value is out of range", [](Network& n) { n.variables[{0}].initial = 2; }},
        {"variable level: its range is empty", [](Network& n) { n.variables[{1}].type.high = -1; }},
        {"variable go: its name is already used", [](Network& n) { n.variables[{1}].name = "go"; }},
        {"the time unit is not positive", [](Network& n) { n.time_unit_ms = 0; }},
        {"template mover: no initial location", [](Network& n) { n.templates[{0}].initial = {7}; }},
        {"an edge leads to a location that does not exist", [&](Network& n) { edge(n, 0).to = {7}; }},
        {"its guard is not Boolean", [&](Network& n) { edge(n, 0).guard = n.exprs.integer(1); }},
        {"its guard contains a type error",
         [&](Network& n) {
             edge(n, 0).guard = n.exprs.conjunction(n.exprs.leaf(Op::Parameter, 0), n.exprs.leaf(Op::Parameter, 1));
         }},
        {"its guard contains a type error", [&](Network& n) { edge(n, 0).guard = n.exprs.leaf(Op::Parameter, 9); }},
        {"its guard contains a type error", [&](Network& n) { edge(n, 0).guard = n.exprs.leaf(Op::Variable, 9); }},
        {"an urgent edge has a clock constraint", [&](Network& n) { edge(n, 1).urgent = true; }},
        {"resets an unknown clock", [&](Network& n) { edge(n, 0).resets = {{4}}; }},
        {"calls an unknown procedure", [&](Network& n) { edge(n, 0).calls = {{0}}; }},
        {"an invariant has a lower bound",
         [](Network& n) { n.templates[{0}].locations[{1}].invariant[0].relation = Op::GreaterEqual; }},
        {"a clock bound reads a variable",
         [&](Network& n) { edge(n, 1).constraint[0].bound = n.exprs.leaf(Op::Parameter, 1); }},
        {"an assignment has a target that cannot be written",
         [&](Network& n) {
             edge(n, 1).assignments = {{n.exprs.leaf(Op::Parameter, 0), n.exprs.constant(true)}};
         }},
        {"an assigned value is not an integer",
         [&](Network& n) { edge(n, 1).assignments[0].value = n.exprs.constant(true); }},
        {"the number of arguments differs from the number of parameters",
         [](Network& n) { n.processes[{0}].arguments.pop_back(); }},
        {"a number is passed for the variable G", [](Network& n) { n.processes[{0}].arguments[0] = std::int64_t{1}; }},
        {"a variable is passed for the constant D",
         [](Network& n) { n.processes[{0}].arguments[2] = Id<Network::Variable>{1}; }},
        {"X has a type that differs from the one of its argument", [](Network& n) { n.variables[{1}].type.high = 9; }},
        {"the argument for D is out of range", [](Network& n) { n.processes[{0}].arguments[2] = std::int64_t{101}; }},
        {"an urgent edge may violate the invariant of its target location",
         [&](Network& n) { edge(n, 0).resets.clear(); }},
        {"reads level before it is written",
         [&](Network& n) {
             n.variables[{1}].scratch = true;
             edge(n, 0).assignments = {{n.exprs.leaf(Op::Variable, 0),
                                        n.exprs.apply(Op::Less, n.exprs.leaf(Op::Variable, 1), n.exprs.integer(1))}};
         }},
        {"property P: an operand contains a type error",
         [](Network& n) { n.properties.add({.name = "P", .operands = {n.exprs.at(0, 5)}}); }},
        {"an operand is not Boolean",
         [](Network& n) { n.properties.add({.name = "P", .operands = {n.exprs.integer(5)}}); }},
        {"property P: its name is already used",
         [](Network& n) {
             n.properties.add({.name = "P", .operands = {n.exprs.constant(true)}});
             n.properties.add({.name = "P", .operands = {n.exprs.constant(true)}});
         }},
        {"settled is not Boolean", [](Network& n) { n.settled = n.exprs.integer(0); }},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.expected);
        Network network = small_network();
        c.damage(network);
        const std::vector<std::string> faults = verify(network);
        const bool named = std::ranges::any_of(
            faults, [&](const std::string& fault) { return fault.find(c.expected) != std::string::npos; });
        EXPECT_TRUE(named) << (faults.empty() ? "no fault" : faults.front());
    }
}

TEST(Network, AnUrgentEdgeKeepsTheInvariantOfItsTarget) {
    struct Case {
        const char* what;
        bool resets;
        Op relation;
        int source_bound;  // -1 means that there is no bound
        bool kept;
    };
    for (const Case& c :
         {Case{"reset", true, Op::LessEqual, -1, true}, Case{"neither", false, Op::LessEqual, -1, false},
          Case{"source as strong", false, Op::LessEqual, 2, true},
          Case{"source stronger", false, Op::LessEqual, 1, true}, Case{"source strict", false, Op::Less, 2, true},
          Case{"source weaker", false, Op::LessEqual, 3, false}}) {
        SCOPED_TRACE(c.what);
        Network network = small_network();
        Network::Template& mover = network.templates[{0}];
        if (!c.resets) mover.edges[{0}].resets.clear();
        if (c.source_bound >= 0)
            mover.locations[{0}].invariant = {{{0}, c.relation, network.exprs.integer(c.source_bound)}};
        EXPECT_EQ(keeps_target_invariant(network, network.processes[{0}], mover.edges[{0}]), c.kept);
    }
}

TEST(Network, ExpandWritesArgumentsInPlaceOfParameters) {
    const Network flat = expand(small_network());
    EXPECT_EQ(verify(flat), std::vector<std::string>{});
    EXPECT_EQ(network_text(flat),
              "network \n"
              "grain phased\n"
              "time unit 1s\n"
              "\n"
              "plant go: bool = false\n"
              "plant level: int 0..3 = 0\n"
              "\n"
              "template Mover\n"
              "    clock t\n"
              "    initial location still\n"
              "    location moving invariant t <= 2\n"
              "    urgent still -> moving when go do t := 0\n"
              "    timed moving -> still when level < 3 && t == 2 do level := level + 1\n"
              "\n"
              "plant Mover = Mover() initially still\n");
}

TEST(RandomizedNetwork, RandomNetworksAreWellFormedAndExpandToTheSameStates) {
    for (int seed = 1; seed <= test_size(300); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Network network = random_network(random);
        ASSERT_EQ(verify(network), std::vector<std::string>{}) << "seed " << seed << '\n' << network_text(network);
        const Network flat = expand(network);
        ASSERT_EQ(verify(flat), std::vector<std::string>{}) << "seed " << seed;
        ASSERT_TRUE(
            std::ranges::all_of(flat.templates, [](const Network::Template& t) { return t.parameters.empty(); }));
        const Reachable before = reachable(network, 300), after = reachable(flat, 300);
        ASSERT_TRUE(before.states == after.states) << "seed " << seed << '\n' << network_text(network);
        const NaiveTadd tadd(network), flat_tadd(flat);
        for (const TaddState& state : before.states) {
            ASSERT_EQ(tadd.settled(state), flat_tadd.settled(state)) << "seed " << seed;
            for (const Id<Property> property : network.properties.ids())
                for (std::size_t i = 0; i < network.properties[property].operands.size(); ++i)
                    ASSERT_EQ(tadd.holds(network.properties[property].operands[i], state),
                              flat_tadd.holds(flat.properties[property].operands[i], state))
                        << "seed " << seed;
        }
    }
}

TEST(RandomizedNetwork, ExpandingTwiceChangesNothing) {
    for (int seed = 1; seed <= test_size(100); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Network once = expand(random_network(random));
        ASSERT_EQ(network_text(expand(once)), network_text(once)) << "seed " << seed;
    }
}

}  // namespace
}  // namespace grafverif
