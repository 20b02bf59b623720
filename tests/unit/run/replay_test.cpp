// SPDX-License-Identifier: MIT
#include "run/replay.hpp"

#include <gtest/gtest.h>

#include "derive/derive.hpp"
#include "ir/network_run.hpp"
#include "run/project.hpp"
#include "support/print_network.hpp"
#include "support/random_loop.hpp"
#include "support/random_walk.hpp"
#include "support/read_loop.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

std::string error_text(const LoopUnderTest& loop, const Run& run) {
    const auto found = disagreement(project(loop.network, run), loop.charts());
    return found ? "move " + std::to_string(found->move) + ", " + found->where + ": " + found->what : "";
}

/// Returns the options for all four combinations of grain and execution mode.
std::vector<ComposeOptions> all_options() {
    std::vector<ComposeOptions> options;
    for (const Grain grain : {Grain::Phased, Grain::Atomic})
        for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle})
            options.push_back({grain, mode, {}});
    return options;
}

TEST(Replay, EveryWalkThroughTheSamplesReplays) {
    int cleared = 0;
    for (const char* sample : {"blinker/blinker.grafcet", "oven_door/oven_door.grafcet", "tanks/tanks.grafcet",
                               "testing_station/testing_station.grafcet", "testing_station/faulty.grafcet"}) {
        for (const ComposeOptions& options : all_options()) {
            const LoopUnderTest loop = read_sample(sample, options);
            for (int seed = 1; seed <= test_size(2); ++seed) {
                SCOPED_TRACE(std::string(sample) + ", seed " + std::to_string(seed));
                Random random(static_cast<std::uint64_t>(seed));
                const auto run = random_walk(loop.network, random, 300);
                EXPECT_EQ(run.moves.size(), 300u);
                ASSERT_EQ(error_text(loop, run), "");
                for (const Move& move : run.moves) cleared += std::holds_alternative<Fire>(move);
            }
        }
    }
    EXPECT_GT(cleared, 1000);
}

/// Counts the cases in the random walks, so that the test fails if the generator no longer produces them.
struct Met {
    int loops = 0, evolutions = 0, timers = 0, races = 0;
};

void meet(const Network& network, const Run& run, Met& met) {
    NetworkState state = initial_state(network);
    for (const Move& move : run.moves) {
        const NetworkState before = state;
        perform(network, state, move);
        for (const Network::Controller& controller : network.controllers) {
            for (const auto& step : controller.words.steps)
                if (before.variables[step.variable.index] < state.variables[step.variable.index]) ++met.evolutions;
            for (const auto& timing : controller.words.timers)
                if (before.variables[timing.end.index] < state.variables[timing.end.index]) ++met.timers;
        }
    }
    if (network.race.valid() && state.variables[network.race.index] != 0) ++met.races;
}

TEST(RandomizedReplay, EveryWalkThroughARandomLoopReplays) {
    Met met;
    for (int seed = 1; seed <= test_size(60); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        Model model = random_loop(random);
        if (seed % 3 == 0) add_task_cycles(model, random);
        Diagnostics diagnostics;
        for (const Chart& chart : model.charts) derive(chart, diagnostics);
        if (diagnostics.has_errors()) continue;
        for (const ComposeOptions& options : all_options()) {
            const LoopUnderTest loop = composed_loop(model, options);
            const auto run = random_walk(loop.network, random, 150);
            ASSERT_EQ(error_text(loop, run), "") << network_text(loop.network);
            meet(loop.network, run, met);
        }
        ++met.loops;
    }
    EXPECT_GT(met.loops, test_size(30));
    EXPECT_GT(met.evolutions, test_size(400));
    EXPECT_GT(met.timers, test_size(4));
    EXPECT_GT(met.races, 0);
}

TEST(RandomizedReplay, DelayMayEndInTheInstantInWhichItsTermFalls) {
    // PART may become false after the inputs were sampled and before the evolution. The timer of LONG may then still
    // count the 3 s after an earlier falling edge of PART.
    constexpr const char* text = R"(
        grafcet light {
            input PART;
            output SHORT, LONG;
            initial step 0 { SHORT if 2s/PART/1s; LONG if 2s/PART/3s; }
        }
        closed_loop light_loop {
            controller light;
            plant Short = lamp(ON = SHORT);
            plant Long = lamp(ON = LONG);
            environment Part = push_button(OUT = PART);
        })";
    for (const ComposeOptions& options : all_options()) {
        const LoopUnderTest loop = read_loop(text, options);
        for (int seed = 1; seed <= test_size(5); ++seed) {
            Random random(static_cast<std::uint64_t>(seed));
            ASSERT_EQ(error_text(loop, random_walk(loop.network, random, 1000)), "") << "seed " << seed;
        }
    }
}

Network::Template& plc(Network& network) {
    return network.templates[network.processes[network.controllers[{0}].process].automaton];
}

/// Omits each assignment of the PLC's procedures in turn.
TEST(Replay, DetectsAnOmittedAssignment) {
    const LoopUnderTest loop = read_sample("oven_door/oven_door.grafcet");
    const Network::Controller& words = loop.network.controllers[{0}];
    int caught = 0, mutants = 0;
    for (const Id<Network::Procedure> procedure : {words.fire, words.evolve, words.write}) {
        LoopUnderTest original = loop;
        const std::size_t count = plc(original.network).procedures[procedure].assignments.size();
        for (std::size_t dropped = 0; dropped < count; ++dropped) {
            LoopUnderTest mutant = loop;
            auto& assignments = plc(mutant.network).procedures[procedure].assignments;
            assignments.erase(assignments.begin() + static_cast<std::ptrdiff_t>(dropped));
            bool seen = false;
            for (std::uint64_t seed = 1; seed <= 4 && !seen; ++seed) {
                Random random(seed);
                seen = !error_text(mutant, random_walk(mutant.network, random, 500)).empty();
            }
            ++mutants;
            caught += seen;
        }
    }
    // Some mutants are not detected, because no evolution reads some of the variables, and because the omission of some
    // resets only produces additional states.
    EXPECT_GT(mutants, 20);
    EXPECT_GE(caught * 10, mutants * 6) << caught << " of " << mutants;
}

/// Returns true if a random walk through the network fails the replay.
bool is_caught(const LoopUnderTest& loop) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        if (!error_text(loop, random_walk(loop.network, random, 200)).empty()) return true;
    }
    return false;
}

TEST(Replay, DetectsScansThatViolateTheTaskCycle) {
    constexpr const char* text = R"(
        grafcet light {
            input PART;
            output L;
            initial step 0;
            step 1 { L; }
            step 2 { L; }
            transition t0: 0 -> 1 when PART;
            transition t1: 1 -> 2 when PART;
            transition t2: 2 -> 0 when 4s/X2 && !PART;
        }
        closed_loop light_loop {
            controller light every 2s..3s;
            environment Part = free(OUT = PART);
        })";
    const LoopUnderTest loop = read_loop(text);
    const Network::Controller controller = loop.network.controllers[{0}];
    EXPECT_FALSE(is_caught(loop));
    LoopUnderTest early = loop, late = loop, blind = loop, torn = loop, slow = loop;
    for (Network::Edge& edge : plc(early.network).edges) edge.constraint.clear();
    plc(late.network).locations[controller.waiting].invariant.clear();
    for (Network::Edge& edge : plc(blind.network).edges)
        if (!edge.urgent) edge.assignments.erase(edge.assignments.begin());
    const Network::Assignment again{torn.network.exprs.leaf(Op::Variable, controller.words.held[0].index),
                                    torn.network.exprs.leaf(Op::Variable, controller.words.inputs[0].variable.index)};
    auto& fire = plc(torn.network).procedures[controller.fire].assignments;
    fire.insert(fire.begin(), again);
    for (Network::Edge& edge : plc(slow.network).edges)  // the outputs may be written later
        if (edge.calls == std::vector{controller.write}) edge.urgent = false;
    for (const LoopUnderTest* mutant : {&early, &late, &blind, &torn, &slow}) EXPECT_TRUE(is_caught(*mutant));
}

TEST(Replay, ReportsWhereARunViolatesTheRules) {
    LoopUnderTest loop = read_sample("blinker/blinker.grafcet");
    auto& write = plc(loop.network).procedures[loop.network.controllers[{0}].write].assignments;
    ASSERT_FALSE(write.empty());
    write.front().value = loop.network.exprs.constant(true);
    Random random(1);
    const auto found = disagreement(project(loop.network, random_walk(loop.network, random, 50)), loop.charts());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->where, "controller blinker, evolution 1");
    EXPECT_EQ(found->what, "output LAMP is 1, but according to the rules 0");
}

TEST(Replay, RejectsAnImpossibleMove) {
    const LoopUnderTest loop = read_sample("blinker/blinker.grafcet");
    const grafverif::Run too_early{{Delay{5}}, {}};  // the first cycle must precede any delay
    const auto found = disagreement(project(loop.network, too_early), loop.charts());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->move, 0u);
    EXPECT_EQ(found->what, "the move is not possible in this state");
}

/// If the timer of the pulse chart has a wrong duration, the evolutions still follow the rules. Therefore, the replay
/// must also compare the timer with the time for which step 1 has been active.
TEST(Replay, ChecksTimersAgainstTheActivityTimesOfSteps) {
    const std::string pulse = R"(
        grafcet pulse {
            input GO; output P;
            initial step 1; step 2 { P; }
            transition t1: 1 -> 2 when 5s/X1;
            transition t2: 2 -> 1 when true;
        }
        closed_loop once { controller pulse; environment Go = push_button(OUT = GO); }
    )";
    LoopUnderTest loop = read_loop(pulse);
    Random random(3);
    EXPECT_EQ(error_text(loop, random_walk(loop.network, random, 300)), "");
    // A timer of 4 s replaces one of 5 s.
    for (Network::Process& process : loop.network.processes)
        if (process.kind == Network::ProcessKind::Timer)
            process.arguments[0] = std::int64_t{4} * 1000 / loop.network.time_unit_ms;
    Random again(3);
    EXPECT_NE(error_text(loop, random_walk(loop.network, again, 300)).find("its age according to the rules is"),
              std::string::npos);
}

}  // namespace
}  // namespace grafverif
