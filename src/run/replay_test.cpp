// SPDX-License-Identifier: MIT
#include "run/replay_test.hpp"

#include <vector>

#include "run/interpreter.hpp"
#include "run/project.hpp"

namespace grafverif {

namespace {

class TestReplay {
public:
    TestReplay(const Chart& chart, const TestSequence& test)
        : chart_(chart), test_(test), inputs_(chart.variables.size()) {}

    /// Executes one step. Returns a description of the difference, or an empty string if there is no difference.
    std::string step(const TestSequence::Step& step) {
        pass(step);
        for (std::uint32_t scan = 1; scan <= step.cycles; ++scan) {
            std::string what = this->scan(step);
            if (what.empty()) what = difference(step);
            if (!what.empty()) return what + " in scan " + std::to_string(scan);
        }
        std::string situation = "{";
        for (const Id<Chart::Step> id : chart_.steps.ids())
            if (state_.situation[id.index]) situation += (situation.size() > 1 ? "," : "") + name_of(chart_, id).text();
        const std::string& expected = test_.situations[step.situation].text;
        const std::string between = " or ";
        const bool one_of =
            (between + expected + between).find(between + situation + '}' + between) != std::string::npos;
        return one_of ? "" : "the situation is " + situation + "} instead of " + expected;
    }

    void power_up() {
        state_ = power_on(chart_);
        time_ms_ = 0;
    }

    /// Returns the run of the chart for a test sequence, up to the first fault.
    ChartRun run_of(const TestSequence::Sequence& sequence) {
        power_up();
        recorded_ = project(chart_, test_.mode);
        std::vector<TestSequence::Step> steps = sequence.steps;
        if (sequence.activation) steps.insert(steps.begin(), *sequence.activation);
        for (const TestSequence::Step& step : steps) {
            pass(step);
            for (std::uint32_t scan = 0; scan < step.cycles; ++scan) {
                const std::string what = this->scan(step);
                if (what.empty()) continue;
                append_instant(*recorded_, what, {}, project(chart_, state_, inputs_, time_ms_));
                return *std::move(recorded_);
            }
        }
        return *std::move(recorded_);
    }

private:
    void pass(const TestSequence::Step& step) {
        state_ = pass_time(std::move(state_), step.wait_ms);
        time_ms_ += step.wait_ms;
    }

    /// Executes a scan. Returns a description of the fault, or an empty string if there is no fault.
    std::string scan(const TestSequence::Step& step) {
        std::size_t input = 0;
        for (const Id<Chart::Variable> id : chart_.variables.ids())
            if (chart_.variables[id].kind == Chart::VariableKind::Input) inputs_[id.index] = step.inputs[input++];
        Cycle run = cycle(chart_, state_, inputs_, test_.mode);
        if (run.race || run.fault) return "a race or a value out of range";
        if (!run.endless.empty() || run.gave_up) return "no stable situation";
        state_ = std::move(run.state);
        if (recorded_)
            append_instant(*recorded_, recorded_->moments.empty() ? "power-on" : "", run.fired,
                           project(chart_, state_, inputs_, time_ms_));
        return {};
    }

    /// Returns the first difference between the outputs and the expected outputs.
    std::string difference(const TestSequence::Step& step) const {
        std::size_t output = 0;
        for (const Id<Chart::Variable> id : chart_.variables.ids()) {
            if (chart_.variables[id].kind != Chart::VariableKind::Output) continue;
            const std::int64_t expected = step.outputs[output++], found = state_.outputs[id.index];
            if (found != expected)
                return "`" + chart_.variables[id].name + "` is " + std::to_string(found) + " instead of " +
                       std::to_string(expected);
        }
        return {};
    }

    const Chart& chart_;
    const TestSequence& test_;
    State state_ = {};
    std::vector<std::int64_t> inputs_ = {};  ///< value of each variable of the chart
    std::int64_t time_ms_ = 0;
    std::optional<ChartRun> recorded_ = {};  ///< the recorded run; empty unless requested
};

}  // namespace

std::optional<std::string> disagreement(const Chart& chart, const TestSequence& test) {
    TestReplay replay(chart, test);
    for (std::size_t k = 0; k < test.sequences.size(); ++k) {
        const TestSequence::Sequence& sequence = test.sequences[k];
        replay.power_up();
        std::string what = sequence.activation ? replay.step(*sequence.activation) : "";
        std::size_t number = 0;
        while (what.empty() && number < sequence.steps.size()) what = replay.step(sequence.steps[number++]);
        if (!what.empty())
            return "sequence " + std::to_string(k + 1) + ", step " + std::to_string(number) + ": " + what;
    }
    return {};
}

std::vector<ChartRun> runs_of(const Chart& chart, const TestSequence& test) {
    TestReplay replay(chart, test);
    std::vector<ChartRun> runs;
    for (const TestSequence::Sequence& sequence : test.sequences) runs.push_back(replay.run_of(sequence));
    return runs;
}

}  // namespace grafverif
