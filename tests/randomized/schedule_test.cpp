// SPDX-License-Identifier: MIT
// Randomized test of schedule: on random charts, the transition system of the controller agrees with the equations of
// the chart, cycle by cycle and in both execution modes. The states that the system marks as quiescent are quiescent.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "derive/derive.hpp"
#include "schedule/controller.hpp"
#include "support/random_chart.hpp"
#include "support/run_equations.hpp"
#include "support/run_transition_system.hpp"
#include "support/test_size.hpp"

namespace grafverif {
namespace {

using Role = Equations::Role;

bool reads_timer(const Equations& equations, Id<Expr> term) {
    return std::ranges::any_of(leaves(equations.exprs, term), [&](Id<Expr> leaf) {
        const auto index = static_cast<std::uint32_t>(equations.exprs[leaf].value);
        return equations.variables[{index}].role == Role::TimerEnd;
    });
}

/// The transition system, executed with the same inputs as the equations. The test simulates its timers.
struct ModelPair {
    const Equations& equations;
    TransitionSystem system = {};
    SystemState state = {};
    std::vector<EquationsTiming> timing = {};
    bool ends_moved = false;        ///< true if some timer output changed in the last step
    std::string before_start = {};  ///< the error before the first step, if there is one

    std::string path(Id<Equations::Variable> variable) const {
        return system.instances[{0}].name + "." + equations.variables[variable].name;
    }
    std::int64_t value(Id<Equations::Variable> variable) const { return value_of(system, state, path(variable)); }

    bool end(std::size_t timer) const { return is_over(equations.timers[timer], timing[timer]); }

    void set_inputs(std::span<const std::int64_t> inputs) {
        for (const Id<Equations::Variable> id : equations.variables.ids())
            if (equations.variables[id].role == Role::Input)
                set_value(system, state, equations.variables[id].name, inputs[id.index]);
        for (std::size_t k = 0; k < timing.size(); ++k)
            set_value(system, state, equations.variables[equations.timers[k].end].name, end(k));
    }

    /// Executes power-on and, if it is observable, the first evolution.
    void start(std::span<const std::int64_t> inputs) {
        state = first_state(system, [](std::string_view, Type type) { return type.low; });
        timing.resize(equations.timers.size());
        set_inputs(inputs);
        for (const Id<Equations::Variable> id : equations.variables.ids())
            if (is_kept(equations.variables[id].role) && value(id) != equations.variables[id].initial)
                before_start = equations.variables[id].name + " is not at its initial value at power-on";
        if (system.controllers.front().starts.valid())
            state = next_state(system, state, [](std::string_view, Type type) { return type.low; });
        watch(inputs);
    }

    static bool is_kept(Role role) { return role == Role::Step || role == Role::Internal || role == Role::Output; }

    /// Updates the level of each timer after a cycle with `inputs` and with the timer outputs that the cycle sampled.
    void watch(std::span<const std::int64_t> inputs) {
        const std::vector<EquationsTiming> sampled = timing;
        for (std::size_t k = 0; k < timing.size(); ++k) {
            const Equations::Timer& timer = equations.timers[k];
            note_level(timer, timing[k].risen >= 0, level(timer, inputs, sampled), timing[k]);
        }
    }

    bool level(const Equations::Timer& timer, std::span<const std::int64_t> inputs,
               const std::vector<EquationsTiming>& sampled) const {
        const auto watch = std::ranges::find(equations.watches, timer.watched, &Equations::ObservedTerm::variable);
        if (watch == equations.watches.end()) return value(timer.watched) != 0;
        const auto found = evaluate(equations.exprs, watch->value, [&](const Expr& leaf) {
            const Id<Equations::Variable> variable{static_cast<std::uint32_t>(leaf.value)};
            const Role role = equations.variables[variable].role;
            if (role == Role::Input) return inputs[variable.index];
            if (role != Role::TimerEnd) return value(variable);
            const auto of = std::ranges::find(equations.timers, variable, &Equations::Timer::end);
            const auto index = static_cast<std::size_t>(of - equations.timers.begin());
            return std::int64_t{is_over(*of, sampled[index])};
        });
        return found.value_or(0) != 0;
    }

    void step(std::span<const std::int64_t> inputs) {
        set_inputs(inputs);
        const SystemState before = state;
        std::vector<bool> old;
        for (std::size_t k = 0; k < timing.size(); ++k) old.push_back(end(k));
        state = next_state(system, before, [](std::string_view, Type type) { return type.low; });
        watch(inputs);
        ends_moved = false;
        for (std::size_t k = 0; k < timing.size(); ++k) ends_moved = ends_moved || old[k] != end(k);
        set_inputs(inputs);
    }

    bool flag(const char* name) const {
        const std::string path = system.instances[{0}].name + "." + name;
        return has_symbol(system, path) && value_of(system, state, path) != 0;
    }
};

/// Returns the first difference after a cycle of the equations, or an empty string.
std::string disagreement(const ModelPair& models, const EquationsCycle& cycle, ExecutionMode mode) {
    const Equations& equations = models.equations;
    // A definite race may hide that another value of the same cycle is undefined.
    const bool faulty = models.flag("out_of_range") || (cycle.no_value && models.flag("race"));
    if ((cycle.no_value || cycle.out_of_range) && !faulty) return "out_of_range is not set";
    if ((cycle.race || cycle.conflict) && !models.flag("race")) return "race is not set";
    if (cycle.no_value || cycle.out_of_range || cycle.race || cycle.conflict || cycle.endless) return {};
    if (models.flag("out_of_range")) return "out_of_range is set";
    if (models.flag("race")) return "race is set";
    for (const Id<Equations::Variable> id : equations.variables.ids()) {
        const Equations::Variable& variable = equations.variables[id];
        if (!ModelPair::is_kept(variable.role)) continue;
        const auto output = std::ranges::find(equations.outputs, id, &Equations::Output::variable);
        // The system samples the inputs and, at the same time, the timer outputs that an output reads. In contrast,
        // run_equations reads the timer outputs after the cycle.
        if (mode == ExecutionMode::EveryCycle && models.ends_moved && output != equations.outputs.end() &&
            reads_timer(equations, output->value))
            continue;
        const std::int64_t expected =
            variable.role == Role::Output ? cycle.state.outputs[id.index] : cycle.state.values[id.index];
        if (models.value(id) != expected)
            return variable.name + " is " + std::to_string(models.value(id)) + ", not " + std::to_string(expected);
    }
    return {};
}

/// Checks that one more cycle with the same inputs changes only flags and previous values if the system marks the state
/// as quiescent.
std::string settled_disagreement(const ModelPair& models, std::span<const std::int64_t> inputs, bool must_be_settled) {
    const bool settled = value_of(models.system, models.state, models.system.settled) != 0;
    if (must_be_settled && !settled) return "not settled after a stable cycle";
    if (!settled) return {};
    ModelPair after = models;
    after.step(inputs);
    for (const Id<Equations::Variable> id : models.equations.variables.ids()) {
        const Role role = models.equations.variables[id].role;
        // The transition system contains no timers, and therefore no variables with these roles.
        if (role == Role::FiringCondition || role == Role::Watched || role == Role::Previous) continue;
        if (models.value(id) != after.value(id))
            return "settled, but " + models.equations.variables[id].name + " changes";
    }
    return {};
}

std::string violation(const Chart& chart, std::uint64_t seed, ExecutionMode mode) {
    Diagnostics diagnostics;
    const auto equations = derive(chart, diagnostics);
    if (!equations) return {};
    Random random(seed);
    ModelPair models{*equations, schedule_controller(*equations, mode)};
    const std::vector<std::string> faults = verify(models.system);
    if (!faults.empty()) return "not well formed: " + faults.front();
    EquationsState state = power_on(*equations);
    for (int macro = 0; macro < 12; ++macro) {
        std::vector<std::int64_t> inputs;
        for (const Equations::Variable& variable : equations->variables)
            inputs.push_back(random_number(random, variable.type.low, variable.type.high));
        const EquationsCycle done = cycle(*equations, state, inputs, mode);
        std::size_t steps = done.fired.size();
        if (macro == 0) {
            models.start(inputs);
            models.set_inputs(inputs);
            if (!models.before_start.empty()) return models.before_start;
            --steps;
        }
        for (std::size_t k = 0; k < steps; ++k) models.step(inputs);
        const std::string found = disagreement(models, done, mode);
        if (!found.empty()) return "cycle " + std::to_string(macro) + ": " + found;
        if (done.no_value || done.race || done.conflict || done.out_of_range || done.endless) break;
        const std::string unsettled = settled_disagreement(models, inputs, mode == ExecutionMode::StabilitySearch);
        if (!unsettled.empty()) return "cycle " + std::to_string(macro) + ": " + unsettled;
        const std::int64_t passed = random_number(random, 0, 3) * 1000;
        state = pass_time(done.state, passed);
        for (EquationsTiming& timing : models.timing) pass_time(timing, passed);
    }
    return {};
}

TEST(RandomizedSchedule, TransitionSystemAgreesWithItsEquations) {
    const int cases = test_size(150);
    std::cout << "seeds 1 to " << cases << '\n';
    for (int seed = 1; seed <= cases; ++seed) {
        for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle}) {
            Random random(static_cast<std::uint64_t>(seed));
            const Chart chart = random_chart(random);
            const auto breaks = [&](const Chart& smaller) {
                return !violation(smaller, static_cast<std::uint64_t>(seed), mode).empty();
            };
            if (!breaks(chart)) continue;
            const Chart small = shrunk(chart, breaks);
            FAIL() << "seed " << seed << ", "
                   << (mode == ExecutionMode::EveryCycle ? "every cycle: " : "stability search: ")
                   << violation(small, static_cast<std::uint64_t>(seed), mode) << '\n'
                   << chart_text(small);
        }
    }
}

}  // namespace
}  // namespace grafverif
