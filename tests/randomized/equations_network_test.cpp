// SPDX-License-Identifier: MIT
// Randomized test of compose: the network of a controller agrees with the equations of the controller, cycle by cycle
// and timer by timer. The test covers both grains and both execution modes. The reference semantics execute the
// network. The test drives the inputs of the controller.
#include <gtest/gtest.h>

#include <algorithm>

#include "compose/compose.hpp"
#include "derive/derive.hpp"
#include "plant/plant.hpp"
#include "support/naive_tadd.hpp"
#include "support/print_network.hpp"
#include "support/random_loop.hpp"
#include "support/run_equations.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

/// A controller that needs more edges or cycles in one instant is assumed never to stabilize.
constexpr int many_edges = 600;

/// The network and the equations of one controller, executed in lockstep.
struct Pair {
    const Equations& equations;
    const Network& network;
    NaiveTadd tadd;
    ExecutionMode mode;
    Random& random;
    TaddState state = {};
    EquationsState expected = {};
    std::vector<std::int64_t> inputs = {};

    Pair(const Equations& of, const Network& as, ExecutionMode how, Random& chance)
        : equations(of),
          network(as),
          tadd(as),
          mode(how),
          random(chance),
          state(tadd.initial()),
          expected(power_on(of)) {
        for (const Equations::Variable& variable : of.variables) inputs.push_back(variable.initial);
    }

    /// Takes edges until time can pass. Timer expiries come first, because the equations treat all expiries of one
    /// instant together. Returns false if a model error occurs or the network never becomes quiescent.
    bool settle() {
        for (int count = 0; count < many_edges; ++count) {
            std::vector<TaddMove> moves = tadd.successors(state);
            std::erase_if(moves, [](const TaddMove& move) { return move.delay(); });
            if (moves.empty()) return true;
            const auto timed = std::ranges::find_if(moves, [&](const TaddMove& move) {
                return !network.templates[network.processes[move.process].automaton].edges[move.edge].urgent;
            });
            const auto any =
                static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(moves.size()) - 1));
            TaddMove& move = timed != moves.end() ? *timed : moves[any];
            if (move.out_of_range) return false;
            state = std::move(move.next);
            if (raced()) return false;
        }
        return false;
    }

    bool raced() const {
        for (const Id<Network::Variable> id : network.variables.ids())
            if (network.variables[id].name == "race") return state.variables[id.index] != 0;
        return false;
    }

    /// Executes cycles of the equations until one is stable. Returns false under the same conditions as settle.
    bool run_cycles() {
        for (int count = 0; count < many_edges; ++count) {
            const EquationsCycle done = cycle(equations, expected, inputs, mode);
            if (done.no_value || done.race || done.conflict || done.out_of_range || done.endless) return false;
            expected = done.state;
            if (done.stable) return true;
        }
        return false;
    }

    void change_inputs() {
        for (const Id<Equations::Variable> id : equations.variables.ids()) {
            const Equations::Variable& variable = equations.variables[id];
            if (variable.role != Equations::Role::Input || !chance(random, 50)) continue;
            inputs[id.index] = random_number(random, variable.type.low, variable.type.high);
            state.variables[tadd.variable_id(variable.name).index] = inputs[id.index];
        }
        state.variables[tadd.variable_id("EVOL_PL").index] = 1;
    }

    /// Lets one unit of time pass; returns true if a timer expires.
    bool pass_unit() {
        state = std::move(tadd.successors(state).back().next);
        const EquationsState before = expected;
        expected = pass_time(std::move(expected), network.time_unit_ms);
        for (std::size_t k = 0; k < equations.timers.size(); ++k)
            if (is_over(equations.timers[k], before.timing[k]) != is_over(equations.timers[k], expected.timing[k]))
                return true;
        return false;
    }

    void compare() const {
        for (const Id<Equations::Variable> id : equations.variables.ids()) {
            const Equations::Variable& variable = equations.variables[id];
            const bool written = variable.role == Equations::Role::Output;
            if (!written && variable.role != Equations::Role::Step && variable.role != Equations::Role::Internal)
                continue;
            const std::int64_t wanted = written ? expected.outputs[id.index] : expected.values[id.index];
            ASSERT_EQ(tadd.variable(state, variable.name), wanted) << variable.name;
        }
        ASSERT_TRUE(tadd.settled(state));
    }
};

/// Runs both models. Returns false if the run ends early because the chart is faulty or unstable.
bool run_both(Pair& pair) {
    const auto agree = [&](bool something_happened) {
        if (something_happened && !pair.run_cycles()) return false;
        EXPECT_TRUE(pair.settle()) << "the equations reach a stable situation, but the network does not";
        pair.compare();
        return !testing::Test::HasFailure();
    };
    if (!agree(true)) return false;
    for (int step = 0; step < 12; ++step) {
        const bool inputs = chance(pair.random, 50);
        if (inputs) pair.change_inputs();
        if (!agree(inputs || pair.pass_unit())) return false;
    }
    return true;
}

void check(std::uint64_t seed, Grain grain, ExecutionMode mode, int& completed) {
    Random random(seed);
    const Chart chart = random_chart(random);
    const Model model = lone_controller(chart);
    Diagnostics diagnostics;
    const auto equations = derive(chart, diagnostics);
    if (!equations) return;  // `derive` rejects outputs that read each other
    const ClosedLoop& loop = model.loops[{0}];
    const auto alone = plant(model, loop, diagnostics);
    ASSERT_TRUE(alone);
    const auto network = compose(*alone, loop, std::span(&*equations, 1), {grain, mode, {}}, diagnostics);
    ASSERT_TRUE(network);
    ASSERT_EQ(verify(*network), std::vector<std::string>{});
    Pair pair(*equations, *network, mode, random);
    completed += run_both(pair);
    if (testing::Test::HasFailure())
        ADD_FAILURE() << "seed " << seed << '\n' << chart_text(chart) << network_text(*network);
}

TEST(RandomizedEquationsNetwork, NetworkAgreesWithItsEquations) {
    const int cases = test_size(150);
    for (const Grain grain : {Grain::Phased, Grain::Atomic}) {
        for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle}) {
            int completed = 0;
            for (int seed = 1; seed <= cases; ++seed) {
                check(static_cast<std::uint64_t>(seed), grain, mode, completed);
                if (HasFailure()) return;
            }
            EXPECT_GT(completed, cases / 4) << "too few runs were complete";
        }
    }
}

}  // namespace
}  // namespace grafverif
