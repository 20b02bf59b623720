// SPDX-License-Identifier: MIT
#include "report/trace_rows.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "derive/derive.hpp"
#include "report/terminal.hpp"
#include "run/project.hpp"
#include "support/random_loop.hpp"
#include "support/random_walk.hpp"
#include "support/read_loop.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

/// Builds a run move by move, with processes given by name.
class Driver {
public:
    explicit Driver(const Network& network) : network_(network), state_(initial_state(network)) {}

    /// Takes the first enabled edge of `process`. If `to` is given, the edge must have that target.
    void fire(const std::string& process, const std::string& to = "") {
        for (const Fire& move : enabled(network_, state_)) {
            const Network::Process& owner = network_.processes[move.process];
            const Network::Template& automaton = network_.templates[owner.automaton];
            if (owner.name != process || (!to.empty() && automaton.locations[automaton.edges[move.edge].to].name != to))
                continue;
            return make(move);
        }
        ADD_FAILURE() << process << " cannot move";
    }
    /// Takes edges of `process` until none is enabled.
    void exhaust(const std::string& process) {
        const auto can = [&] {
            for (const Fire& move : enabled(network_, state_))
                if (network_.processes[move.process].name == process) return true;
            return false;
        };
        while (can()) fire(process);
    }
    void wait(std::int64_t units) { make(Delay{units}); }
    void loop_from_here() { run_.loop = run_.moves.size(); }

    const Run& run() const { return run_; }

private:
    void make(const Move& move) {
        EXPECT_EQ(perform(network_, state_, move).result, Step::Result::Done);
        run_.moves.push_back(move);
    }

    const Network& network_;
    NetworkState state_;
    Run run_ = {};
};

ChartRun trace_of(const Network& network, const Run& run, Detail detail = Detail::Chart) {
    return with_rows(project(network, run), detail);
}

std::string table(const ChartRun& run) {
    EXPECT_EQ(verify(run), std::vector<std::string>{});
    std::ostringstream out;
    print_trace(run, out);
    return out.str();
}

std::vector<std::int64_t> values(const ChartRun& run, const ChartRun::Row& row, ChartRun::Role role) {
    std::vector<std::int64_t> list;
    for (const Id<ChartRun::Signal> id : signals_of(run, role)) list.push_back(run.after(row).values[id.index]);
    return list;
}

TEST(TraceRows, TraceOfTheBlinkerUsesTheNamesOfItsChart) {
    const LoopUnderTest loop = read_sample("blinker/blinker.grafcet");
    Driver drive(loop.network);
    drive.exhaust("PLC");
    drive.wait(1);
    drive.fire("Button");
    drive.exhaust("PLC");  // the controller runs up to its request of a timer
    drive.fire("T_X1_2s", "run");
    drive.exhaust("PLC");
    drive.fire("Lamp");
    drive.wait(2);
    drive.fire("T_X1_2s", "done");
    drive.exhaust("PLC");
    drive.exhaust("T_X1_2s");
    drive.exhaust("T_X2_1s");
    drive.exhaust("PLC");
    EXPECT_EQ(table(trace_of(loop.network, drive.run())),
              "  time  event                   inputs  cleared  situation  outputs\n"
              "   0 s  blinker: power on       none             0          none\n"
              "   1 s  Button                  BUTTON\n"
              "        blinker                         t0       1          LAMP\n"
              "        Lamp: lit\n"
              "   3 s  blinker: 2s/X1 is true\n"
              "        blinker                         t1       2          none\n");
}

TEST(TraceRows, ListsTheEvolutionsOfOneSearchInOrder) {
    const LoopUnderTest loop = read_loop(R"(
        grafcet chain { input GO; output DONE; internal N: int 0..3 = 0;
            initial step 0; step 1; step 2 { DONE; N := N + 2 on activation; }
            transition a: 0 -> 1 when GO; transition b: 1 -> 2 when true; }
        closed_loop one { controller chain with stability_search; environment Go = free(OUT = GO); }
    )");
    Driver drive(loop.network);
    drive.exhaust("PLC");
    drive.fire("Go");
    drive.exhaust("PLC");
    const ChartRun trace = trace_of(loop.network, drive.run());
    ASSERT_EQ(trace.rows.size(), 3u);
    const ChartRun::Row& search = trace.rows.back();
    EXPECT_EQ(search.kind, ChartRun::Kind::Controller);
    EXPECT_EQ(search.fired, (std::vector<std::vector<Id<ChartRun::Transition>>>{{{0}}, {{1}}}));
    EXPECT_EQ(trace.after(search).situation, (std::vector<Id<ChartRun::Step>>{{2}}));
    EXPECT_EQ(values(trace, search, ChartRun::Role::Output), (std::vector<std::int64_t>{1}));
    EXPECT_EQ(values(trace, search, ChartRun::Role::Internal), (std::vector<std::int64_t>{2}));
    EXPECT_NE(table(trace).find("chain: N 0 -> 2"), std::string::npos);
}

TEST(TraceRows, SplitsACycleIfThePlantMovesDuringIt) {
    const LoopUnderTest loop = read_loop(R"(
        grafcet watch { input GO; output L; initial step 0; step 1 { L; } transition t: 0 -> 1 when GO; }
        closed_loop one { controller watch; environment Go = free(OUT = GO); }
    )");
    Driver drive(loop.network);
    drive.exhaust("PLC");
    drive.fire("Go");
    drive.fire("PLC", "P0");
    drive.fire("PLC", "P1");
    drive.fire("Go");  // GO is reset too late, after the inputs were sampled
    drive.fire("PLC", "P2");
    drive.fire("Go");  // this event is between the evolution and the outputs
    drive.exhaust("PLC");
    EXPECT_EQ(table(trace_of(loop.network, drive.run())),
              "  time  event                           inputs  cleared  situation  outputs\n"
              "   0 s  watch: power on                 none             0          none\n"
              "        Go                              GO\n"
              "        watch: inputs sampled\n"
              "        Go                              !GO\n"
              "        watch: outputs not yet written          t        1\n"
              "        Go                              GO\n"
              "        watch                                            1          L\n");
}

TEST(TraceRows, MarksTheLoop) {
    const LoopUnderTest loop = read_sample("blinker/blinker.grafcet");
    Driver drive(loop.network);
    drive.exhaust("PLC");
    drive.wait(1);
    drive.loop_from_here();
    drive.wait(1);
    const ChartRun trace = trace_of(loop.network, drive.run());
    ASSERT_EQ(trace.loop_from, 2u);
    EXPECT_EQ(trace.rows[2].what, "time passes, forever");
}

TEST(TraceRows, LoopWithoutVisibleEventsHasARow) {
    // The cycle of CEP13 Fig. 17 without flags runs forever, and no time passes.
    const LoopUnderTest loop = read_sample("blinker/blinker.grafcet", {.ablations = {.cycle_always = true}});
    Driver drive(loop.network);
    for (int i = 0; i < 4; ++i) drive.fire("PLC");
    drive.loop_from_here();
    for (int i = 0; i < 4; ++i) drive.fire("PLC");
    const ChartRun trace = trace_of(loop.network, drive.run());
    EXPECT_EQ(verify(trace), std::vector<std::string>{});
    ASSERT_EQ(trace.loop_from, trace.rows.size() - 1);
    EXPECT_EQ(trace.rows.back().what, "cycles repeat forever, no time passes, nothing changes");
}

TEST(TraceRows, HidesInternalEventsByDefault) {
    const LoopUnderTest loop = read_sample("testing_station/testing_station.grafcet");
    Random random(2);
    const auto run = random_walk(loop.network, random, 300);
    const ChartRun plain = trace_of(loop.network, run);
    const ChartRun all = trace_of(loop.network, run, Detail::Everything);
    const auto hidden = [](const ChartRun::Row& row) { return row.internal; };
    EXPECT_EQ(std::ranges::count_if(plain.rows, hidden), 0);
    EXPECT_GT(std::ranges::count_if(all.rows, hidden), 20);
    EXPECT_EQ(all.after(all.rows.back()), plain.after(plain.rows.back()));
    const std::string text = table(plain);
    for (const char* inner : {"P0", "P1", "EVOL", "CF_", "stable", "X_"})
        EXPECT_EQ(text.find(inner), std::string::npos) << inner;
}

TEST(TraceRows, UsesFullStepNamesOnlyIfNeeded) {
    const LoopUnderTest loop = read_loop(R"(
        grafcet twins { input GO; output L;
            initial step 1; step 2 { L; } transition t: 1 -> 2 when GO;
            partial G2 { initial step 2; step 3; transition u: 2 -> 3 when !GO; } }
        closed_loop one { controller twins; environment Go = free(OUT = GO); }
    )");
    const ChartRun trace = trace_of(loop.network, {});
    std::vector<std::string> full, shorter;
    for (const ChartRun::Step& step : trace.steps) {
        full.push_back(step.full_name());
        shorter.push_back(step.short_name);
    }
    EXPECT_EQ(full, (std::vector<std::string>{"1", "2", "G2.2", "G2.3"}));
    EXPECT_EQ(shorter, (std::vector<std::string>{"1", "2", "G2.2", "3"}));
}

TEST(RandomizedTraceRows, TracesOfRandomWalksAreWellFormed) {
    int rows = 0;
    for (int seed = 1; seed <= test_size(40); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop(random);
        Diagnostics diagnostics;
        for (const Chart& chart : model.charts) derive(chart, diagnostics);
        if (diagnostics.has_errors()) continue;
        for (const Grain grain : {Grain::Phased, Grain::Atomic}) {
            const LoopUnderTest loop = composed_loop(model, {.grain = grain});
            const auto run = random_walk(loop.network, random, 80);
            for (const Detail detail : {Detail::Chart, Detail::Everything}) {
                const ChartRun trace = trace_of(loop.network, run, detail);
                ASSERT_EQ(verify(trace), std::vector<std::string>{});
                std::istringstream lines(table(trace));
                for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u);
                rows += static_cast<int>(trace.rows.size());
            }
        }
    }
    EXPECT_GT(rows, test_size(1000));
}

/// The last row always shows the current state of the run.
TEST(RandomizedTraceRows, StepsOfATraceEndWithTheRun) {
    for (const char* sample :
         {"oven_door/oven_door.grafcet", "tanks/tanks.grafcet", "testing_station/faulty.grafcet"}) {
        for (const Grain grain : {Grain::Phased, Grain::Atomic}) {
            const LoopUnderTest loop = read_sample(sample, {.grain = grain});
            for (int seed = 1; seed <= test_size(4); ++seed) {
                SCOPED_TRACE(std::string(sample) + ", seed " + std::to_string(seed));
                Random random(static_cast<std::uint64_t>(seed));
                const auto run = random_walk(loop.network, random, 200);
                const auto states = replay(loop.network, run);
                ASSERT_TRUE(states);
                std::int64_t ms = 0;
                for (const Move& move : run.moves)
                    if (const auto* delay = std::get_if<Delay>(&move)) ms += delay->units * loop.network.time_unit_ms;
                const ChartRun trace = trace_of(loop.network, run);
                EXPECT_EQ(verify(trace), std::vector<std::string>{});
                const ChartRun::State& end = trace.after(trace.rows.back());
                EXPECT_EQ(end.time_ms, ms);
                const auto variable = [&](const std::string& name) {
                    return states->back().variables[static_cast<std::size_t>(
                        std::ranges::find(loop.network.variables, name, &Network::Variable::name) -
                        loop.network.variables.begin())];
                };
                for (const Id<ChartRun::Signal> id : trace.signals.ids())
                    EXPECT_EQ(end.values[id.index], variable(trace.signals[id].name)) << trace.signals[id].name;
                std::vector<Id<ChartRun::Step>> situation;
                const auto& steps = loop.network.controllers[{0}].words.steps;
                for (std::uint32_t i = 0; i < steps.size(); ++i)
                    if (states->back().variables[steps[i].variable.index] != 0) situation.push_back({i});
                EXPECT_EQ(end.situation, situation);
            }
        }
    }
}

}  // namespace
}  // namespace grafverif
