// SPDX-License-Identifier: MIT
// Randomized tests of task cycles. The network of a controller with a task cycle, executed by the reference semantics,
// agrees with the interpreter, which is called scan by scan. The test drives the inputs, chooses the time of each scan
// in the range of the cycle, and changes inputs during a scan, which the controller must not notice.
#include <gtest/gtest.h>

#include <algorithm>

#include "compose/compose.hpp"
#include "derive/derive.hpp"
#include "plant/plant.hpp"
#include "run/scanner.hpp"
#include "support/naive_tadd.hpp"
#include "support/print_network.hpp"
#include "support/random_loop.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

constexpr int many_edges = 600;  // a controller that needs more edges in one instant is assumed never to stabilize

struct Seen {
    int scans = 0, changes = 0, late = 0;
};

/// A network and its chart, executed in lockstep.
class Pair {
public:
    Pair(const Chart& chart, const Network& network, ExecutionMode mode, Random& random, Seen& seen)
        : chart_(chart),
          network_(network),
          tadd_(network),
          scanner_(chart, mode),
          mode_(mode),
          random_(random),
          seen_(seen) {
        for (const Id<Chart::Variable> input : scanner_.inputs()) values_.push_back(chart.variables[input].initial);
        const TaskCycle cycle = *network.controllers[{0}].words.cycle;
        least_ = cycle.least_ms / network.time_unit_ms;
        most_ = cycle.most_ms / network.time_unit_ms;
    }

    /// Returns false if the chart has a fault or never becomes stable.
    bool run() {
        change_inputs();
        if (!scan()) return false;
        for (int count = 0; count < 12; ++count) {
            const std::int64_t due = random_number(random_, least_, most_);
            for (std::int64_t units = 1; units <= due; ++units) {
                if (!pass_unit()) return false;
                if (chance(random_, 40)) change_inputs();
                EXPECT_EQ(can_scan(), units >= least_);
                EXPECT_EQ(can_pass(), units < most_);
                if (testing::Test::HasFailure()) return false;
            }
            if (!scan()) return false;
        }
        return true;
    }

private:
    Id<Network::Process> plc() const { return network_.controllers[{0}].process; }
    const Network::Edge& edge_of(const TaddMove& move) const {
        return network_.templates[network_.processes[move.process].automaton].edges[move.edge];
    }
    bool is_scan(const TaddMove& move) const { return move.process == plc() && !edge_of(move).urgent; }
    bool can_scan() const {
        return std::ranges::any_of(tadd_.successors(state_),
                                   [&](const TaddMove& move) { return !move.delay() && is_scan(move); });
    }
    bool can_pass() const { return std::ranges::any_of(tadd_.successors(state_), &TaddMove::delay); }
    /// True during a scan that searches for stability.
    bool in_scan() const {
        return state_.locations[plc().index] != network_.controllers[{0}].waiting.index ||
               state_.variables[network_.controllers[{0}].stable.index] == 0;
    }

    void put_inputs() {
        for (std::size_t k = 0; k < values_.size(); ++k)
            state_.variables[tadd_.variable_id(chart_.variables[scanner_.inputs()[k]].name).index] = values_[k];
    }
    void change_inputs() {
        for (std::size_t k = 0; k < values_.size(); ++k) {
            const Type& type = chart_.variables[scanner_.inputs()[k]].type;
            if (chance(random_, 50)) values_[k] = random_number(random_, type.low, type.high);
        }
        put_inputs();
    }

    /// Takes edges until time can pass. Elapsed delays come first, because the interpreter treats all delays of one
    /// instant together. `scans` is true if the next scan is due.
    bool settle(bool scans) {
        for (int count = 0; count < many_edges; ++count) {
            std::vector<TaddMove> moves = tadd_.successors(state_);
            std::erase_if(moves, [&](const TaddMove& move) { return move.delay() || (is_scan(move) && !scans); });
            if (moves.empty()) return true;
            const auto timer = std::ranges::find_if(moves, [&](const TaddMove& move) { return move.process != plc(); });
            TaddMove& move = timer != moves.end() ? *timer : moves.front();
            if (move.out_of_range) return false;
            scans = scans && !is_scan(move);
            state_ = std::move(move.next);
            if (network_.race.valid() && state_.variables[network_.race.index] != 0) return false;
            if (mode_ == ExecutionMode::EveryCycle || !in_scan() || chance(random_, 80)) continue;
            change_inputs();
            ++seen_.changes;
        }
        return false;
    }

    bool scan() {
        const std::vector<std::int64_t> sampled = values_;
        if (!scanner_.scan(sampled).empty() || !settle(true)) return false;
        ++seen_.scans;
        compare();
        return !testing::Test::HasFailure();
    }

    bool pass_unit() {
        const std::vector<TaddMove> moves = tadd_.successors(state_);
        EXPECT_TRUE(moves.back().delay()) << "time must pass between two scans";
        state_ = moves.back().next;
        scanner_.wait(network_.time_unit_ms);
        if (!settle(false)) return false;
        const std::vector<bool> over = time_conditions(chart_, scanner_.state());
        seen_.late += std::ranges::find(over, true) != over.end();
        return !testing::Test::HasFailure();
    }

    void compare() const {
        for (const Id<Chart::Step> step : chart_.steps.ids())
            EXPECT_EQ(state_.variables[network_.controllers[{0}].words.steps[step.index].variable.index],
                      scanner_.state().situation[step.index] ? 1 : 0)
                << name_of(chart_, step).text();
        for (const Id<Chart::Variable> id : chart_.variables.ids()) {
            const Chart::Variable& variable = chart_.variables[id];
            if (variable.kind == Chart::VariableKind::Input) continue;
            const bool written = variable.kind == Chart::VariableKind::Output;
            EXPECT_EQ(tadd_.variable(state_, variable.name),
                      written ? scanner_.state().outputs[id.index] : scanner_.state().values[id.index])
                << variable.name;
        }
        EXPECT_EQ(tadd_.settled(state_), tadd_.variable(state_, "stable") != 0);
    }

    const Chart& chart_;
    const Network& network_;
    NaiveTadd tadd_;
    Scanner scanner_;
    ExecutionMode mode_;
    Random& random_;
    Seen& seen_;
    TaddState state_ = tadd_.initial();
    std::vector<std::int64_t> values_ = {};  ///< values of the inputs, in order
    std::int64_t least_ = 0, most_ = 0;
};

void check(std::uint64_t seed, Grain grain, ExecutionMode mode, int& completed, Seen& seen) {
    Random random(seed);
    const Chart chart = random_chart(random);
    Model model = lone_controller(chart);
    add_task_cycles(model, random);
    Diagnostics diagnostics;
    const auto equations = derive(chart, diagnostics);
    if (!equations) return;  // `derive` rejects outputs that read each other
    const ClosedLoop& loop = model.loops[{0}];
    const auto alone = plant(model, loop, diagnostics);
    ASSERT_TRUE(alone);
    const auto network = compose(*alone, loop, std::span(&*equations, 1), {grain, mode, {}}, diagnostics);
    ASSERT_TRUE(network);
    ASSERT_EQ(verify(*network), std::vector<std::string>{});
    completed += Pair(chart, *network, mode, random, seen).run();
    if (testing::Test::HasFailure())
        ADD_FAILURE() << "seed " << seed << '\n' << chart_text(chart) << network_text(*network);
}

TEST(RandomizedTaskCycle, NetworkAgreesWithTheInterpreterScanByScan) {
    const int cases = test_size(100);
    Seen seen;
    for (const Grain grain : {Grain::Phased, Grain::Atomic}) {
        for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle}) {
            int completed = 0;
            for (int seed = 1; seed <= cases; ++seed) {
                check(static_cast<std::uint64_t>(seed), grain, mode, completed, seen);
                if (HasFailure()) return;
            }
            EXPECT_GT(completed, cases / 4) << "too few runs were complete";
        }
    }
    EXPECT_GT(seen.scans, 10 * cases);
    EXPECT_GT(seen.changes, cases);
    EXPECT_GT(seen.late, cases);
}

}  // namespace
}  // namespace grafverif
