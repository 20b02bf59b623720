// SPDX-License-Identifier: MIT
#include "support/run_equations.hpp"

#include <set>

namespace grafverif {

namespace {

using Variable = Equations::Variable;

struct Runner {
    const Equations& equations;
    std::span<const std::int64_t> inputs;
    EquationsCycle result;

    /// Evaluates the term over `values`. If the term is undefined, returns 0 and sets `no_value`.
    std::int64_t value(Id<Expr> term, const std::vector<std::int64_t>& values) {
        const auto found = evaluate(equations.exprs, term,
                                    [&](const Expr& leaf) { return values[static_cast<std::size_t>(leaf.value)]; });
        result.no_value = result.no_value || !found;
        return found.value_or(0);
    }

    /// Returns the values before the cycle, which contain the current inputs and timer outputs.
    std::vector<std::int64_t> before() const {
        std::vector<std::int64_t> values = result.state.values;
        for (const Id<Variable> id : equations.variables.ids())
            if (equations.variables[id].role == Equations::Role::Input) values[id.index] = inputs[id.index];
        for (std::size_t k = 0; k < equations.timers.size(); ++k)
            values[equations.timers[k].end.index] = is_over(equations.timers[k], result.state.timing[k]);
        return values;
    }

    void store(const Equations::Stored& stored, std::int64_t next) {
        const Type type = equations.variables[stored.variable].type;
        if (next < type.low || next > type.high) result.out_of_range = true;
        result.state.values[stored.variable.index] = next;
    }

    void start() {
        const std::vector<std::int64_t> old = before();
        result.fired.emplace_back();
        for (const Equations::Stored& stored : equations.stored) {
            if (value(stored.first_race, old) != 0) result.race = true;
            store(stored, value(stored.first, old));
        }
        remember(old);
        watch(old);
        result.state.started = true;
        result.stable = false;
    }

    void evolve() {
        std::vector<std::int64_t> old = before();
        result.fired.emplace_back();
        for (std::size_t k = 0; k < equations.firings.size(); ++k) {
            const std::int64_t fires = value(equations.firings[k].condition, old);
            old[equations.firings[k].variable.index] = fires;
            if (fires != 0) result.fired.back().push_back(k);
        }
        if (result.no_value) return;
        for (const Equations::StepActivity& step : equations.steps) {
            result.state.values[step.variable.index] = value(step.next, old);
            const bool was = old[step.variable.index] != 0, is = result.state.values[step.variable.index] != 0;
            result.torn = result.torn || (value(step.activated, old) != 0) != (!was && is) ||
                          (value(step.deactivated, old) != 0) != (was && !is);
        }
        for (const Equations::Stored& stored : equations.stored) {
            if (value(stored.race, old) != 0) result.race = true;
            store(stored, value(stored.next, old));
        }
        for (const Equations::Conflict& conflict : equations.conflicts)
            if (value(conflict.condition, old) != 0) result.conflict = true;
        result.stable = value(equations.stable, old) != 0;
        remember(old);
        watch(old);
    }

    void remember(const std::vector<std::int64_t>& old) {
        for (const Equations::Previous& previous : equations.previous)
            result.state.values[previous.variable.index] = value(previous.value, old);
    }

    /// Updates the levels after the cycle, with the inputs and timer outputs that the cycle sampled.
    void watch(const std::vector<std::int64_t>& old) {
        std::vector<std::int64_t> after = result.state.values;
        for (const Id<Variable> id : equations.variables.ids())
            if (equations.variables[id].role == Equations::Role::Input ||
                equations.variables[id].role == Equations::Role::TimerEnd)
                after[id.index] = old[id.index];
        for (const Equations::ObservedTerm& watched : equations.watches)
            result.state.values[watched.variable.index] = value(watched.value, after);
        for (std::size_t k = 0; k < equations.timers.size(); ++k) {
            const std::uint32_t watched = equations.timers[k].watched.index;
            note_level(equations.timers[k], result.state.timing[k].risen >= 0, result.state.values[watched] != 0,
                       result.state.timing[k]);
        }
    }

    void write() {
        const std::vector<std::int64_t> after = before();
        for (const Equations::Output& output : equations.outputs)
            result.state.values[output.variable.index] = result.state.outputs[output.variable.index] =
                value(output.value, after);
        for (const Equations::Stored& stored : equations.stored)
            if (equations.variables[stored.variable].role == Equations::Role::Output)
                result.state.outputs[stored.variable.index] = after[stored.variable.index];
    }
};

}  // namespace

bool is_over(const Equations::Timer& timer, const EquationsTiming& timing) {
    const bool lasts = timing.risen >= 0 && timing.risen >= timer.rise_ms;
    return lasts || (timing.fallen >= 0 && timing.fallen < timer.fall_ms);
}

void note_level(const Equations::Timer& timer, bool before, bool after, EquationsTiming& timing) {
    if (before && !after && timing.risen >= timer.rise_ms) timing.fallen = 0;
    if (before != after) timing.risen = after ? 0 : -1;
}

void pass_time(EquationsTiming& timing, std::int64_t milliseconds) {
    for (std::int64_t* age : {&timing.risen, &timing.fallen})
        if (*age >= 0) *age += milliseconds;
}

EquationsState power_on(const Equations& equations) {
    EquationsState state;
    for (const Variable& variable : equations.variables) state.values.push_back(variable.initial);
    state.timing.resize(equations.timers.size());
    state.outputs = state.values;
    return state;
}

EquationsCycle cycle(const Equations& equations, const EquationsState& state, std::span<const std::int64_t> inputs,
                     ExecutionMode mode) {
    Runner runner{equations, inputs, {}};
    EquationsCycle& result = runner.result;
    result.state = state;
    std::set<EquationsState> seen;
    while (true) {
        if (result.state.started) runner.evolve();
        else runner.start();
        if (result.no_value || result.race || result.out_of_range || result.conflict) return result;
        if (mode == ExecutionMode::EveryCycle || result.stable) break;
        result.endless = !seen.insert(result.state).second;
        if (result.endless) return result;
    }
    runner.write();
    return result;
}

EquationsState pass_time(EquationsState state, std::int64_t milliseconds) {
    for (EquationsTiming& timing : state.timing) pass_time(timing, milliseconds);
    return state;
}

}  // namespace grafverif
