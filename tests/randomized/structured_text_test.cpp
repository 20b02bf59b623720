// SPDX-License-Identifier: MIT
// Randomized test: a small PLC simulator that does not use charts executes the controller in
// Structured Text. The simulator agrees with the interpreter cycle by cycle, in both execution
// modes and both forms, in the outputs, the situation, and the point at which the controller stops.
#include "emit/structured_text/structured_text.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "derive/derive.hpp"
#include "randomized/controller_cases.hpp"
#include "run/interpreter.hpp"
#include "support/random_chart.hpp"
#include "support/run_structured_text.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

using structured_text::Form;

std::string controller_text(const Equations& equations, ExecutionMode mode, Form form) {
    std::ostringstream out;
    structured_text::emit(equations, {mode, 1000, form}, out);
    return form == Form::Text ? std::move(out).str() : units_of_plcopen(std::move(out).str());
}

std::string disagreement(const Chart& chart, const Equations& equations, const Cycle& run, const SmallPlc& plc) {
    const int fault = fault_of(run);
    const auto found = plc.value("FAULT");
    const bool either = fault > 1 && found > 1;  // any of several faults in one evolution may be reported
    if (found != fault && !either) return "fault " + std::to_string(found) + " instead of " + std::to_string(fault);
    for (const Id<Chart::Variable> id : chart.variables.ids())
        if (chart.variables[id].kind == Chart::VariableKind::Output &&
            plc.value(chart.variables[id].name) != run.state.outputs[id.index])
            return "output " + chart.variables[id].name;
    if (fault != 0) return {};
    for (std::size_t k = 0; k < equations.steps.size(); ++k)
        if (plc.value(equations.variables[equations.steps[k].variable].name) != (run.state.situation[k] ? 1 : 0))
            return "step " + equations.steps[k].step.text();
    return {};
}

std::string violation(const Chart& chart, std::uint64_t seed, ExecutionMode mode, Met& met) {
    Diagnostics diagnostics;
    const auto equations = derive(chart, diagnostics);
    if (!equations) return ++met.refused, "";
    if (!structured_text::expressible(*equations, diagnostics)) return ++met.refused, "";
    Random random(seed);
    SmallPlc plc({controller_text(*equations, mode, chance(random, 50) ? Form::Text : Form::PlcopenXml)}, chart.name);
    State state = power_on(chart);
    std::vector<std::int64_t> inputs = state.values;
    std::int64_t now = 0;
    for (int k = 0; k < 14; ++k) {
        const Cycle run = cycle(chart, state, inputs, mode);
        for (const Id<Chart::Variable> id : chart.variables.ids())
            if (chart.variables[id].kind == Chart::VariableKind::Input)
                plc.set(chart.variables[id].name, inputs[id.index]);
        plc.call(now);
        meet(chart, state, run, met);
        const std::string what = disagreement(chart, *equations, run, plc);
        if (!what.empty()) return "cycle " + std::to_string(k + 1) + ": " + what;
        if (fault_of(run) != 0) return {};
        for (const Id<Chart::Variable> id : chart.variables.ids()) {
            const Chart::Variable& variable = chart.variables[id];
            if (variable.kind == Chart::VariableKind::Input && chance(random, 40))
                inputs[id.index] = random_number(random, variable.type.low, variable.type.high);
        }
        const std::int64_t delay = chance(random, 40) ? 500 * random_number(random, 1, 6) : 0;
        state = pass_time(run.state, delay);
        now += delay;
    }
    return {};
}

std::string violation_or_error(const Chart& chart, std::uint64_t seed, ExecutionMode mode, Met& met) {
    try {
        return violation(chart, seed, mode, met);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

TEST(RandomizedStructuredText, ControllerAgreesWithTheRulesOfTheStandard) {
    Met met;
    for (int seed = 1; seed <= test_size(300); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Chart chart = random_chart(random);
        for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle}) {
            const std::uint64_t run_seed = random();
            if (violation_or_error(chart, run_seed, mode, met).empty()) continue;
            Met ignored;
            const Chart smallest = shrunk(chart, [&](const Chart& smaller) {
                return !violation_or_error(smaller, run_seed, mode, ignored).empty();
            });
            Diagnostics diagnostics;
            FAIL() << "seed " << seed
                   << (mode == ExecutionMode::EveryCycle ? ", every cycle, " : ", stability search, ")
                   << violation_or_error(smallest, run_seed, mode, ignored) << "\n\n"
                   << chart_text(smallest) << '\n'
                   << controller_text(*derive(smallest, diagnostics), mode, Form::Text);
        }
    }
    EXPECT_LT(met.refused, test_size(300));
    EXPECT_GT(met.transients, 30);
    EXPECT_GT(met.endless, 10);
    EXPECT_GT(met.races, 5);
    EXPECT_GT(met.out_of_range, 5);
    EXPECT_GT(met.outputs, 300);
    EXPECT_GT(met.timed, 50);
}

}  // namespace
}  // namespace grafverif
