// SPDX-License-Identifier: MIT
// Compares searches with and without macro-steps, which omit transient states within PLC cycles, on random loops, with
// and without observers and input abstraction. Each premise of macro-steps is omitted once, to show that the comparison
// detects the omission.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "check/timed/machine.hpp"
#include "check/timed/timed.hpp"
#include "compose/observe.hpp"
#include "ir/network_inputs.hpp"
#include "ir/patterns.hpp"
#include "support/random_loop.hpp"
#include "support/random_panel.hpp"
#include "support/read_loop.hpp"
#include "support/row_counts.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

constexpr std::uint64_t most_states = 30'000;

/// Restricts the network to its properties about single states.
Network about_states(Network network) {
    for (const Property& property : std::exchange(network.properties, {}))
        if (is_about_states(property.pattern)) network.properties.add(property);
    return network;
}

/// Returns the abstraction with the coarsest level for each process: Chosen if possible, otherwise Untimed.
InputAbstraction coarse(const Network& network) {
    const std::vector<AbstractableProcess> processes = abstractable_processes(network);
    std::vector<InputLevel> levels;
    for (const AbstractableProcess& process : processes)
        levels.push_back(process.valuations.empty() ? InputLevel::Untimed : InputLevel::Chosen);
    store_what_is_read(processes, levels);
    return abstract_inputs(network, processes, levels);
}

/// Compares the verdicts of one network. Returns the number of properties with different verdicts.
int compare(const Network& network, const std::vector<InputChoice>& choices, const MacroStepOptions& macro_steps,
            std::map<std::string, int>& seen) {
    TimedOptions options{.max_states = most_states, .timelock = false, .choices = choices, .paths = true};
    const TimedResult plain = check_timed(network, options);
    options.macro_steps = macro_steps;
    const TimedResult macro = check_timed(network, options);
    if (!plain.complete || !macro.complete) return 0;
    int different = plain.errors.empty() == macro.errors.empty() ? 0 : 1;
    seen["states without macro-steps"] += static_cast<int>(plain.states);
    seen["states with macro-steps"] += static_cast<int>(macro.states);
    for (std::size_t k = 0; k < plain.verdicts.size(); ++k) {
        const Verdict& verdict = macro.verdicts[k];
        // A model error ends a search; a search without macro-steps may find a violation before the error.
        const bool is_ended = !macro.errors.empty() && verdict.outcome == Outcome::Unknown;
        if (verdict.outcome != plain.verdicts[k].outcome && !is_ended) ++different;
        ++seen["verdicts: " + std::string(word(verdict.outcome))];
        if (!verdict.run || !choices.empty()) continue;
        EXPECT_TRUE(replay(network, *verdict.run)) << verdict.property;
        ++seen["runs"];
    }
    return different;
}

/// Adds properties that often are decided only within a cycle: combinations of a step, an output and a timer output.
Network with_combinations(Network network) {
    for (const Network::Controller& controller : network.controllers)
        for (std::size_t step = 0; step < std::min<std::size_t>(4, controller.words.steps.size()); ++step)
            for (const auto& output : controller.words.outputs) {
                if (!network.variables[output.variable].type.boolean) continue;
                const Id<Expr> active = network.exprs.leaf(Op::Variable, controller.words.steps[step].variable.index);
                const Id<Expr> on = network.exprs.leaf(Op::Variable, output.variable.index);
                const std::string name = std::to_string(network.properties.size());
                network.properties.add({.name = "on_" + name,
                                        .pattern = Pattern::Reachable,
                                        .operands = {network.exprs.conjunction(active, on)}});
                network.properties.add({.name = "off_" + name,
                                        .pattern = Pattern::Never,
                                        .operands = {network.exprs.conjunction(active, network.exprs.negation(on))}});
                for (const auto& timer : controller.words.timers) {
                    const Id<Expr> ended = network.exprs.leaf(Op::Variable, timer.end.index);
                    network.properties.add(
                        {.name = "ended_" + name,
                         .pattern = Pattern::Never,
                         .operands = {network.exprs.conjunction(
                             network.exprs.conjunction(active, network.exprs.negation(on)), ended)}});
                }
            }
    return network;
}

/// Replaces the properties by properties that read instances. All instances are untimed, so they can move within PLC
/// cycles.
InputAbstraction with_moving_instances(const Network& network) {
    const std::vector<AbstractableProcess> processes = abstractable_processes(network);
    InputAbstraction abstraction =
        abstract_inputs(network, processes, std::vector<InputLevel>(processes.size(), InputLevel::Untimed));
    Network& made = abstraction.network;
    made.properties = {};
    const auto add = [&](Id<Expr> term, bool at_stable) {
        made.properties.add({.name = std::to_string(made.properties.size()),
                             .pattern = Pattern::Reachable,
                             .operands = {term},
                             .at_stable = at_stable});
    };
    for (const Id<Network::Process> id : made.processes.ids()) {
        const Network::ProcessKind kind = made.processes[id].kind;
        if (kind != Network::ProcessKind::Plant && kind != Network::ProcessKind::Environment) continue;
        for (const Id<Network::Location> location : made.templates[made.processes[id].automaton].locations.ids())
            add(made.exprs.at(id.index, location.index), false);
    }
    for (const Network::Controller& controller : made.controllers)
        for (const auto& step : controller.words.steps)
            for (const auto& input : controller.words.inputs) {
                if (!made.variables[input.variable].type.boolean || !made.settled.valid()) continue;
                const Id<Expr> active = made.exprs.leaf(Op::Variable, step.variable.index);
                const Id<Expr> on = made.exprs.leaf(Op::Variable, input.variable.index);
                add(made.exprs.conjunction(active, on), true);
                add(made.exprs.conjunction(active, made.exprs.negation(on)), true);
            }
    return abstraction;
}

/// Compares the verdicts of a loop, of the loop with each observer, and of their coarse abstractions. The abstractions
/// of loops with observers are not compared, because an observer may read an instance of level Chosen.
int compare(const Network& loop, const MacroStepAblations& without, std::map<std::string, int>& seen) {
    const MacroStepOptions exact{.enabled = true, .without = without};
    int different = compare(with_combinations(about_states(observed(loop, {}))), {}, exact, seen);
    for (const Id<Property> id : watched(loop))
        different += compare(about_states(observed(loop, {id})), {}, exact, seen);
    InputAbstraction abstraction = coarse(loop);
    // The abstraction does not define properties that read instances of level Chosen.
    abstraction.network.properties = {};
    for (const Id<Network::Controller> id : loop.controllers.ids())
        for (const auto& step : loop.controllers[id].words.steps)
            for (const bool stable : {false, true})
                abstraction.network.properties.add(
                    {.name = std::string(stable ? "stable_" : "") + loop.variables[step.variable].name,
                     .pattern = Pattern::Reachable,
                     .operands = {abstraction.network.exprs.leaf(Op::Variable, step.variable.index)},
                     .at_stable = stable && loop.settled.valid()});
    abstraction.network = with_combinations(std::move(abstraction.network));
    const InputAbstraction moving = with_moving_instances(loop);
    different += compare(
        moving.network, moving.choices,
        {.enabled = true, .deferred = moving.deferred, .unprompted = moving.unprompted, .without = without}, seen);
    different += compare(
        abstraction.network, abstraction.choices,
        {.enabled = true, .deferred = abstraction.deferred, .unprompted = abstraction.unprompted, .without = without},
        seen);
    return different;
}

Network panel(std::uint64_t seed) {
    Random random(seed);
    const std::string text = random_panel(random, {.faulty = chance(random, 10), .progress = false});
    return expand(read_loop(text, {.grain = Grain::Phased}).network);
}

TEST(MacroSteps, PanelsGetTheVerdictsOfTheSearchWithoutMacroSteps) {
    std::map<std::string, int> seen;
    for (int seed = 1; seed <= test_size(60) && !testing::Test::HasFailure(); ++seed)
        EXPECT_EQ(compare(panel(static_cast<std::uint64_t>(seed)), {}, seen), 0) << "seed " << seed;
    print_counts(seen);
    EXPECT_GT(seen["verdicts: holds"], test_size(20));
    EXPECT_GT(seen["verdicts: violated"], test_size(5));
    EXPECT_LT(seen["states with macro-steps"], seen["states without macro-steps"]);
}

TEST(MacroSteps, RandomLoopsGetTheVerdictsOfTheSearchWithoutMacroSteps) {
    std::map<std::string, int> seen;
    for (int seed = 1; seed <= test_size(150) && !testing::Test::HasFailure(); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        try {
            EXPECT_EQ(compare(expand(composed_loop(random_loop(random)).network), {}, seen), 0) << "seed " << seed;
        } catch (const std::invalid_argument&) {
            ++seen["cannot be composed"];
        }
    }
    print_counts(seen);
    EXPECT_GT(seen["runs"], test_size(50));
    EXPECT_LT(seen["states with macro-steps"], seen["states without macro-steps"]);
}

/// Macro-steps call Machine::may_move to recognize most states that are not transient.
TEST(MacroSteps, TheTestOfOneProcessAgreesWithTheMovesOfTheState) {
    int moving = 0, resting = 0;
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test_size(40)); ++seed) {
        const Network network = panel(seed);
        const timed::Machine machine(network);
        std::vector<timed::Word> words = timed::packed_initial(network, machine.layout());
        timed::Moves moves;
        Random random(seed);
        for (int step = 0; step < 200; ++step) {
            machine.expand(words.data(), moves);
            if (moves.fault) break;
            for (const Id<Network::Process> id : network.processes.ids()) {
                const bool has_move = std::ranges::any_of(
                    moves.edges, [&](std::uint32_t edge) { return machine.process_of(edge) == id; });
                const bool may_move = machine.may_move(id.index, words.data(), moves.registers);
                // The invariant of the target location can forbid an edge, but not in these loops.
                ASSERT_EQ(may_move, has_move) << "seed " << seed << ", " << network.processes[id].name;
                ++(may_move ? moving : resting);
            }
            const bool passes = !moves.urgent && (moves.edges.empty() || chance(random, 40));
            if (passes && machine.delay(words.data())) continue;
            if (moves.edges.empty()) break;
            const std::size_t move = random() % moves.edges.size();
            std::copy_n(moves.words.begin() + static_cast<std::ptrdiff_t>(move * words.size()), words.size(),
                        words.begin());
        }
    }
    EXPECT_GT(moving, test_size(1000));
    EXPECT_GT(resting, test_size(1000));
}

TEST(MacroSteps, EachPremiseIsNeeded) {
    struct Premise {
        const char* name = "";
        bool MacroStepAblations::*omitted = nullptr;
    };
    for (const Premise& premise : {Premise{"states that decide a property are stored", &MacroStepAblations::properties},
                                   Premise{"nothing else reads the timers", &MacroStepAblations::timers},
                                   Premise{"no other process can move", &MacroStepAblations::processes},
                                   Premise{"shared variables are unchanged", &MacroStepAblations::changes}}) {
        MacroStepAblations without;
        without.*premise.omitted = true;
        std::map<std::string, int> seen;
        int different = 0;
        for (std::uint64_t seed = 1; different == 0 && seed < 400; ++seed) {
            Random random(seed);
            try {
                different += compare(seed % 2 == 0 ? panel(seed) : expand(composed_loop(random_loop(random)).network),
                                     without, seen);
            } catch (const std::invalid_argument&) {
                continue;
            }
        }
        EXPECT_GT(different, 0) << premise.name;
    }
}

}  // namespace
}  // namespace grafverif
