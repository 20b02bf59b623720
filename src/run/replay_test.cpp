// SPDX-License-Identifier: MIT
#include "run/replay_test.hpp"

#include <vector>

#include "run/interpreter.hpp"

namespace grafverif {

namespace {

class TestReplay {
public:
    TestReplay(const Chart& chart, const TestSequence& test)
        : chart_(chart), test_(test), inputs_(chart.variables.size()) {}

    /// What is wrong with one step, or nothing.
    std::string step(const TestSequence::Step& step) {
        state_ = pass_time(std::move(state_), step.wait_ms);
        for (std::uint32_t scan = 1; scan <= step.cycles; ++scan)
            if (std::string what = this->scan(step); !what.empty()) return what + " in scan " + std::to_string(scan);
        std::string situation = "{";
        for (const Id<Chart::Step> id : chart_.steps.ids())
            if (state_.situation[id.index]) situation += (situation.size() > 1 ? "," : "") + name_of(chart_, id).text();
        const std::string& expected = test_.situations[step.situation].text;
        const std::string between = " or ";
        const bool one_of =
            (between + expected + between).find(between + situation + '}' + between) != std::string::npos;
        return one_of ? "" : "the situation is " + situation + "} instead of " + expected;
    }

    void power_up() { state_ = power_on(chart_); }

private:
    std::string scan(const TestSequence::Step& step) {
        std::size_t input = 0;
        for (const Id<Chart::Variable> id : chart_.variables.ids())
            if (chart_.variables[id].kind == Chart::VariableKind::Input) inputs_[id.index] = step.inputs[input++];
        Cycle run = cycle(chart_, state_, inputs_, test_.mode);
        if (run.race || run.fault) return "a race or a value that does not fit";
        if (!run.endless.empty() || run.gave_up) return "no stable situation";
        state_ = std::move(run.state);
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
    std::vector<std::int64_t> inputs_ = {};  ///< per variable of the chart
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

}  // namespace grafverif
