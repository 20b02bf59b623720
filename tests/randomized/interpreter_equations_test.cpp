// SPDX-License-Identifier: MIT
// Randomized test: the interpreter of the IEC rules agrees with the equations that derive computes from the same chart,
// cycle by cycle and in both execution modes. The interpreter uses only sets of steps and transitions. The test
// compares the transitions cleared, the situation, the variables, the outputs written, stability, total instability,
// races and values out of range.
#include <gtest/gtest.h>

#include <sstream>

#include "derive/derive.hpp"
#include "run/interpreter.hpp"
#include "support/random_chart.hpp"
#include "support/run_equations.hpp"
#include "support/test_size.hpp"
#include "syntax/print/equations.hpp"

namespace grafverif {
namespace {

constexpr int cycles_per_run = 14;

/// Counts the cases in the random runs, so that the test fails if the generator no longer produces them.
struct Met {
    int fired = 0, several = 0, transients = 0, endless = 0, races = 0, out_of_range = 0, stored = 0, outputs = 0,
        timed = 0, edges = 0, macros = 0, enclosed = 0, forced = 0, apart = 0;
};

std::vector<std::int64_t> random_inputs(const Chart& chart, std::vector<std::int64_t> values, Random& random) {
    for (const Id<Chart::Variable> id : chart.variables.ids()) {
        const Chart::Variable& variable = chart.variables[id];
        if (variable.kind == Chart::VariableKind::Input && chance(random, 40))
            values[id.index] = random_number(random, variable.type.low, variable.type.high);
    }
    return values;
}

/// Returns the first disagreement of one cycle, or an empty string.
std::string disagreement(const Chart& chart, const Equations& equations,
                         const std::vector<std::int64_t>& outputs_before, const Cycle& run,
                         const EquationsCycle& algebra) {
    const bool stopped = algebra.no_value || algebra.race || algebra.out_of_range || algebra.conflict;
    if ((run.race || run.fault) != stopped) return "a race, a term without value or a value out of range";
    // If an evolution has several faults, either implementation may report any of them.
    if (algebra.no_value || (run.fault && run.fault->kind == RunFault::Kind::NoValue)) return {};
    const bool apart = run.fault && run.fault->kind == RunFault::Kind::ForcedApart;
    if (apart != algebra.conflict) return "conflict of forcing orders";
    if (apart) return {};
    if (run.race.has_value() != algebra.race) return "race";
    if (run.race) return {};
    if (run.fault.has_value() != algebra.out_of_range) return "value out of range";
    if (run.fault) return {};
    std::vector<std::vector<std::size_t>> fired;
    for (const auto& evolution : run.fired) {
        fired.emplace_back();
        for (const Id<Chart::Transition> transition : evolution) fired.back().push_back(transition.index);
    }
    if (algebra.torn) return "activated or deactivated";
    if (run.endless.empty() == algebra.endless) return "total instability";
    if (algebra.endless) return run.state.outputs == outputs_before ? "" : "outputs written in an unstable situation";
    if (fired != algebra.fired) return "transitions fired";
    if (run.stable != algebra.stable) return "stable";
    for (std::size_t k = 0; k < equations.steps.size(); ++k)
        if (run.state.situation[k] != (algebra.state.values[equations.steps[k].variable.index] != 0))
            return "situation";
    for (const Id<Chart::Variable> id : chart.variables.ids()) {
        const Chart::Variable& variable = chart.variables[id];
        if (variable.kind == Chart::VariableKind::Internal &&
            run.state.values[id.index] != algebra.state.values[id.index])
            return "internal " + variable.name;
        if (variable.kind == Chart::VariableKind::Output &&
            run.state.outputs[id.index] != algebra.state.outputs[id.index])
            return "output " + variable.name;
    }
    return {};
}

void meet(const Chart& chart, const State& before, const Cycle& run, Met& met) {
    if (run.race) ++met.races;
    if (run.fault && run.fault->kind == RunFault::Kind::OutOfRange) ++met.out_of_range;
    if (!run.endless.empty()) ++met.endless;
    if (run.fired.size() > 2) ++met.transients;
    for (const auto& evolution : run.fired) {
        if (!evolution.empty()) ++met.fired;
        if (evolution.size() > 1) ++met.several;
    }
    if (run.state.values != before.values) ++met.stored;
    if (run.state.outputs != before.outputs) ++met.outputs;
    for (const bool elapsed : time_conditions(chart, before)) met.timed += elapsed ? 1 : 0;
    if (run.state.previous != before.previous) ++met.edges;
    if (run.fault && run.fault->kind == RunFault::Kind::ForcedApart) ++met.apart;
    for (const Chart::PartialChart& partial : chart.partial_charts) {
        if (!partial.owner.valid() || run.state.situation[partial.owner.index] == before.situation[partial.owner.index])
            continue;
        ++(partial.kind == Chart::PartialKind::Expansion ? met.macros : met.enclosed);
    }
    for (const Chart::ForcingOrder& order : chart.forcing)
        if (run.state.situation[order.step.index] && !before.situation[order.step.index]) ++met.forced;
}

/// Runs the interpreter and the equations with the inputs and delays of `seed`. Returns the first difference, or an
/// empty string.
std::string violation(const Chart& chart, std::uint64_t seed, ExecutionMode mode, Met& met) {
    Diagnostics diagnostics;
    const auto equations = derive(chart, diagnostics);
    if (!equations && diagnostics.all().front().code == "forced-twice") return {};
    if (!equations) return "derive refuses the chart: " + diagnostics.all().front().message;
    for (const std::string& fault : verify(*equations)) return "verify: " + fault;
    Random random(seed);
    State state = power_on(chart);
    EquationsState values = power_on(*equations);
    std::vector<std::int64_t> inputs = state.values;
    for (int k = 0; k < cycles_per_run; ++k) {
        const Cycle run = cycle(chart, state, inputs, mode);
        std::vector<std::int64_t> extended = inputs;  // the variables of the equations begin with those of the chart
        extended.resize(equations->variables.size());
        const EquationsCycle algebra = cycle(*equations, values, extended, mode);
        meet(chart, state, run, met);
        const std::string what = disagreement(chart, *equations, state.outputs, run, algebra);
        if (!what.empty()) return "cycle " + std::to_string(k + 1) + ": " + what;
        if (run.race || run.fault || !run.endless.empty()) return {};
        inputs = random_inputs(chart, inputs, random);
        const std::int64_t delay = chance(random, 40) ? 500 * random_number(random, 1, 6) : 0;
        state = pass_time(run.state, delay);
        values = pass_time(algebra.state, delay);
    }
    return {};
}

std::string equations_text(const Chart& chart) {
    Diagnostics diagnostics;
    const auto equations = derive(chart, diagnostics);
    std::ostringstream out;
    if (equations) print_equations(out, *equations);
    return out.str();
}

TEST(RandomizedInterpreterEquations, EquationsAgreeWithTheRulesOfTheStandard) {
    Met met;
    for (int seed = 1; seed <= test_size(500); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Chart chart = random_chart(random);
        for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle}) {
            const std::uint64_t run_seed = random();
            if (violation(chart, run_seed, mode, met).empty()) continue;
            Met ignored;
            const Chart smallest = shrunk(
                chart, [&](const Chart& smaller) { return !violation(smaller, run_seed, mode, ignored).empty(); });
            FAIL() << "seed " << seed
                   << (mode == ExecutionMode::EveryCycle ? ", every cycle, " : ", stability search, ")
                   << violation(smallest, run_seed, mode, ignored) << "\n\n"
                   << chart_text(smallest) << '\n'
                   << equations_text(smallest);
        }
    }
    EXPECT_GT(met.fired, 1000);
    EXPECT_GT(met.several, 100);
    EXPECT_GT(met.transients, 50);
    EXPECT_GT(met.endless, 20);
    EXPECT_GT(met.races, 10);
    EXPECT_GT(met.out_of_range, 10);
    EXPECT_GT(met.stored, 100);
    EXPECT_GT(met.outputs, 500);
    EXPECT_GT(met.timed, 100);
    EXPECT_GT(met.edges, 100);
    EXPECT_GT(met.macros, 50);
    EXPECT_GT(met.enclosed, 50);
    EXPECT_GT(met.forced, 20);
    EXPECT_GE(met.apart, 1);
}

}  // namespace
}  // namespace grafverif
