// SPDX-License-Identifier: MIT
// Randomized tests of plant and compose on random closed loops.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "support/naive_tadd.hpp"
#include "support/print_network.hpp"
#include "support/test_size.hpp"
#include "unit/compose/hand_chart.hpp"

namespace grafverif {
namespace {

bool derivable(const Model& model) {
    Diagnostics diagnostics;
    for (const Chart& chart : model.charts) derive(chart, diagnostics);
    return !diagnostics.has_errors();
}

/// Returns the observable part of a state as text: the variables that both grains have, the locations of the plant and
/// the timers, and the clocks.
std::string visible(const Network& network, const TaddState& state) {
    std::string text;
    std::map<std::string, std::int64_t> values;
    for (const Id<Network::Variable> id : network.variables.ids()) {
        const Network::Variable& variable = network.variables[id];
        const bool inner = variable.role == Network::Role::FiringCondition || variable.role == Network::Role::Sample;
        if (!inner && !variable.scratch) values[variable.name] = state.variables[id.index];
    }
    for (const auto& [name, value] : values) text += name + "=" + std::to_string(value) + " ";
    for (const Id<Network::Process> id : network.processes.ids())
        if (network.processes[id].kind != Network::ProcessKind::Controller)
            text += std::to_string(state.locations[id.index]) + ",";
    for (const std::int64_t clock : state.clocks) text += std::to_string(clock) + ";";
    return text;
}

TEST(RandomizedLoop, RandomLoopsComposeToWellFormedNetworksEachTimeTheSame) {
    int composed_loops = 0;
    for (int seed = 1; seed <= test_size(200); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        Model model = random_loop(random);
        if (seed % 3 == 0) add_task_cycles(model, random);
        if (!derivable(model)) continue;
        const Network network = composed(model);
        ASSERT_FALSE(HasFailure()) << network_text(network);
        ASSERT_EQ(network_text(composed(model)), network_text(network));
        ASSERT_EQ(verify(expand(network)), std::vector<std::string>{});
        ++composed_loops;
    }
    EXPECT_GT(composed_loops, test_size(200) / 2);
}

TEST(RandomizedLoop, TheFlagIsSetOnEveryEdgeOfThePlantThatAssignsAnInputAndOnNoOther) {
    for (int seed = 1; seed <= test_size(200); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        Model model = random_loop(random);
        if (seed % 3 == 0) add_task_cycles(model, random);
        if (!derivable(model)) continue;
        const ClosedLoop& loop = model.loops[{0}];
        const Network flat = expand(composed(model));
        for (const Id<ClosedLoop::Instance> instance : loop.instances.ids()) {
            const Network::Process& process = flat.processes[{instance.index}];
            for (const Network::Edge& edge : flat.templates[process.automaton].edges) {
                std::set<std::string> wanted, found;
                for (const Network::Assignment& assignment : edge.assignments) {
                    const std::string& name =
                        flat.variables[{static_cast<std::uint32_t>(flat.exprs[assignment.target].value)}].name;
                    if (name.ends_with("EVOL_PL")) {
                        found.insert(name);
                        continue;
                    }
                    for (const ClosedLoop::Controller& controller : loop.controllers)
                        for (const Chart::Variable& variable : model.charts[controller.chart].variables)
                            if (!controller.cycle && variable.name == name &&
                                variable.kind == Chart::VariableKind::Input)
                                wanted.insert(loop.controllers.size() > 1 ? controller.name + "_EVOL_PL" : "EVOL_PL");
                }
                ASSERT_EQ(found, wanted) << network_text(flat);
            }
        }
    }
}

TEST(RandomizedLoop, QuiescentStatesOfTheAtomicGrainAreQuiescentInThePhasedGrain) {
    int compared = 0;
    for (int seed = 1; seed <= test_size(60); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        Model model = random_loop(random);
        if (seed % 3 == 0) add_task_cycles(model, random);
        if (!derivable(model)) continue;
        const Network atomic = composed(model, {.grain = Grain::Atomic}),
                      phased = composed(model, {.grain = Grain::Phased});
        const Reachable fine = reachable(phased, 6000);
        if (!fine.complete) continue;
        const Reachable coarse = reachable(atomic, 6000);
        const NaiveTadd fine_tadd(phased), coarse_tadd(atomic);
        std::set<std::string> seen;
        for (const TaddState& state : fine.states)
            if (fine_tadd.settled(state)) seen.insert(visible(phased, state));
        for (const TaddState& state : coarse.states)
            ASSERT_TRUE(!coarse_tadd.settled(state) || seen.contains(visible(atomic, state))) << network_text(atomic);
        ++compared;
    }
    EXPECT_GT(compared, test_size(60) / 6);
}

TEST(RandomizedLoop, QuiescentStateEnablesNoUrgentEdge) {
    for (int seed = 1; seed <= test_size(60); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        Model model = random_loop(random);
        if (seed % 3 == 0) add_task_cycles(model, random);
        if (!derivable(model)) continue;
        const Network network = composed(model);
        const NaiveTadd tadd(network);
        for (const TaddState& state : reachable(network, 400).states) {
            if (tadd.settled(state)) {
                ASSERT_FALSE(tadd.urgent_enabled(state));
                continue;
            }
            const bool waits = std::ranges::all_of(network.controllers, [&](const Network::Controller& controller) {
                return state.locations[controller.process.index] == controller.waiting.index;
            });
            // In mode every-cycle with a task cycle, the next scan may change the situation.
            const bool scans = std::ranges::any_of(network.controllers, [&](const Network::Controller& controller) {
                return controller.words.cycle && state.variables[controller.stable.index] == 0;
            });
            if (waits && !scans && !tadd.urgent_enabled(state))
                ADD_FAILURE() << "no edge must be taken, but the state is not quiescent\n" << network_text(network);
            if (HasFailure()) return;
        }
    }
}

}  // namespace
}  // namespace grafverif
