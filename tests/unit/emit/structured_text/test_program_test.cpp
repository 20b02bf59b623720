// SPDX-License-Identifier: MIT
// Tests that the test program passes with the controller of its chart, and that it finds the row in which another
// controller differs.
#include <gtest/gtest.h>

#include <sstream>

#include "derive/derive.hpp"
#include "emit/structured_text/structured_text.hpp"
#include "run/interpreter.hpp"
#include "support/random_chart.hpp"
#include "support/run_structured_text.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

using structured_text::Form;

constexpr std::int64_t tick = 250;  ///< milliseconds between two calls while the test waits

TestSequence without_steps(const Chart& chart, ExecutionMode mode) {
    TestSequence test;
    test.chart = chart.name;
    test.mode = mode;
    test.situations.add({"{}"});
    for (const Chart::Variable& variable : chart.variables) {
        if (variable.kind == Chart::VariableKind::Input) test.inputs.push_back({variable.name, variable.type});
        if (variable.kind == Chart::VariableKind::Output) test.outputs.push_back({variable.name, variable.type});
    }
    return test;
}

std::vector<std::int64_t> values_of(const Chart& chart, Chart::VariableKind kind,
                                    const std::vector<std::int64_t>& values) {
    std::vector<std::int64_t> picked;
    for (const Id<Chart::Variable> id : chart.variables.ids())
        if (chart.variables[id].kind == kind) picked.push_back(values[id.index]);
    return picked;
}

/// Returns a random walk of the chart as a sequence, which is shorter if the chart cannot continue.
TestSequence::Sequence walk(const Chart& chart, ExecutionMode mode, Random& random) {
    TestSequence::Sequence sequence;
    State state = power_on(chart);
    std::vector<std::int64_t> inputs = state.values;
    for (int k = 0; k < 12; ++k) {
        TestSequence::Step step;
        if (k > 0 && chance(random, 30)) step.wait_ms = tick * random_number(random, 1, 12);
        for (const Id<Chart::Variable> id : chart.variables.ids())
            if (chart.variables[id].kind == Chart::VariableKind::Input && step.wait_ms == 0 && chance(random, 50))
                inputs[id.index] = random_number(random, chart.variables[id].type.low, chart.variables[id].type.high);
        const Cycle run = cycle(chart, pass_time(state, step.wait_ms), inputs, mode);
        if (run.race || run.fault || !run.endless.empty()) break;
        state = run.state;
        step.inputs = values_of(chart, Chart::VariableKind::Input, inputs);
        step.outputs = values_of(chart, Chart::VariableKind::Output, state.outputs);
        step.situation = {0};
        step.cycles = run.stable ? 2 : 1;
        if (step.cycles == 2) state = cycle(chart, state, inputs, mode).state;
        sequence.steps.push_back(std::move(step));
    }
    return sequence;
}

std::string text_of(const TestSequence& test, Form form) {
    std::ostringstream out;
    structured_text::emit_test(test, form, out);
    return form == Form::Text ? std::move(out).str() : units_of_plcopen(std::move(out).str());
}

/// Runs the test to its end. Time passes only in calls that wait.
void run(SmallPlc& plc) {
    std::int64_t now = 0;
    for (int calls = 0; plc.value("done") == 0; ++calls) {
        ASSERT_LT(calls, 10'000) << "the test never ends";
        const std::int64_t row = plc.value("row"), scan = plc.value("scan");
        plc.call(now);
        if (plc.value("row") == row && plc.value("scan") == scan) now += tick;
    }
}

TEST(StructuredTextTest, FindsTheRowThatDiffersAndNoOther) {
    int tests = 0, waits = 0, differences = 0, several = 0;
    for (int seed = 1; seed <= test_size(120); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Chart chart = random_chart(random);
        Diagnostics diagnostics;
        const auto equations = derive(chart, diagnostics);
        if (!equations || !structured_text::expressible(*equations, diagnostics)) continue;
        const ExecutionMode mode = chance(random, 50) ? ExecutionMode::StabilitySearch : ExecutionMode::EveryCycle;
        TestSequence test = without_steps(chart, mode);
        if (test.inputs.empty() || test.outputs.empty()) continue;
        for (std::int64_t left = random_number(random, 1, 3); left > 0; --left) {
            test.sequences.push_back(walk(chart, mode, random));
            if (test.sequences.back().steps.empty()) test.sequences.pop_back();
        }
        if (test.sequences.empty()) continue;
        ASSERT_EQ(verify(test), std::vector<std::string>{}) << seed;
        std::ostringstream controller;
        structured_text::emit(*equations, {mode, 1000, Form::Text}, controller);
        const Form form = chance(random, 50) ? Form::Text : Form::PlcopenXml;

        SmallPlc right({controller.str(), text_of(test, form)}, "test_" + chart.name);
        run(right);
        EXPECT_EQ(right.value("passed"), 1) << "seed " << seed << ", row " << right.value("failed_row") << "\n"
                                            << chart_text(chart) << text_of(test, Form::Text);
        ++tests;
        several += test.sequences.size() > 1 ? 1 : 0;

        std::int64_t row = 0, wrong = 0;
        for (TestSequence::Sequence& sequence : test.sequences)
            for (TestSequence::Step& step : sequence.steps) {
                ++row;
                waits += step.wait_ms != 0 ? 1 : 0;
                if (wrong != 0 || !test.outputs[0].type.boolean || !chance(random, 15)) continue;
                wrong = row;
                step.outputs[0] = 1 - step.outputs[0];
            }
        if (wrong == 0) continue;
        ++differences;
        SmallPlc found({controller.str(), text_of(test, form)}, "test_" + chart.name);
        run(found);
        EXPECT_EQ(found.value("passed"), 0);
        EXPECT_EQ(found.value("failed_row"), wrong) << "seed " << seed;
    }
    EXPECT_GT(tests, 60);
    EXPECT_GT(several, 20);
    EXPECT_GT(waits, 100);
    EXPECT_GT(differences, 30);
}

}  // namespace
}  // namespace grafverif
