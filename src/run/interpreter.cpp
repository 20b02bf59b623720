// SPDX-License-Identifier: MIT
#include "grafverif/run/interpreter.hpp"

#include <algorithm>
#include <utility>

namespace grafverif {

namespace {

/// Takes the value of terms of the chart over one situation and one set of values. Continuous outputs that conditions
/// read are looked up once each.
class Reader {
public:
    Reader(const Chart& chart, const State& state, InputValues inputs, const std::vector<bool>* timed)
        : chart_(chart), state_(state), inputs_(inputs), timed_(timed) {}

    /// Empty where the term has no value.
    std::optional<std::int64_t> value(Id<Expr> term) {
        const bool outer = std::exchange(lost_, false);  // of the term that asks for an output, whose condition this is
        const auto result = evaluate(chart_.exprs, term, [this](const Expr& leaf) { return leaf_value(leaf); });
        const bool lost = std::exchange(lost_, outer);
        return lost ? std::nullopt : result;
    }

    /// Whether some action sets `output` now.
    std::optional<std::int64_t> output(Id<Chart::Variable> output) {
        if (known_.empty()) index_actions();
        Known& known = known_[output.index];
        if (known != Known::No)
            return known == Known::Lost ? std::nullopt : std::optional(std::int64_t{known == Known::True});
        const std::optional<std::int64_t> result = look_up(output);
        known = !result ? Known::Lost : *result != 0 ? Known::True : Known::False;
        return result;
    }

    /// Whether an action stores values in `variable`.
    bool is_stored(Id<Chart::Variable> variable) {
        if (known_.empty()) index_actions();
        return stored_[variable.index];
    }

private:
    enum class Known : std::uint8_t { No, False, True, Lost };

    std::int64_t leaf_value(const Expr& leaf) {
        const auto index = static_cast<std::size_t>(leaf.value);
        if (leaf.op == Op::Step) return state_.situation[index];
        if (leaf.op == Op::Timed) return (*timed_)[index];
        const Id<Chart::Variable> variable{static_cast<std::uint32_t>(index)};
        const Chart::VariableKind kind = chart_.variables[variable].kind;
        if (kind == Chart::VariableKind::Input) return inputs_[index];
        if (kind == Chart::VariableKind::Internal || is_stored(variable)) return state_.values[index];
        const std::optional<std::int64_t> set = output(variable);
        lost_ = lost_ || !set;
        return set.value_or(0);
    }

    std::optional<std::int64_t> look_up(Id<Chart::Variable> output) {
        if (!chart_.variables[output].type.boolean) return state_.values[output.index];
        for (const Id<Chart::ContinuousAction> id : actions_[output.index]) {
            const Chart::ContinuousAction& action = chart_.continuous[id];
            if (!state_.situation[action.step.index]) continue;
            const std::optional<std::int64_t> condition = value(action.condition);
            if (!condition || *condition != 0) return condition;
        }
        return 0;
    }

    void index_actions() {
        known_.assign(chart_.variables.size(), Known::No);
        stored_.assign(chart_.variables.size(), false);
        actions_.resize(chart_.variables.size());
        for (const Chart::StoredAction& action : chart_.stored) stored_[action.target.index] = true;
        for (const Id<Chart::ContinuousAction> id : chart_.continuous.ids())
            actions_[chart_.continuous[id].output.index].push_back(id);
    }

    const Chart& chart_;
    const State& state_;
    InputValues inputs_;
    const std::vector<bool>* timed_;   ///< null where no time condition can be read: in assignation conditions
    std::vector<Known> known_ = {};
    std::vector<bool> stored_ = {};
    std::vector<std::vector<Id<Chart::ContinuousAction>>> actions_ = {};
    bool lost_ = false;                ///< an output read by the term at hand has no value
};

/// Rules 2 and 4: the transitions to clear, all from the old situation.
void clear_transitions(const Chart& chart, const State& old, Reader& reader, Evolution& evolution) {
    for (const Id<Chart::Transition> id : chart.transitions.ids()) {
        const Chart::Transition& transition = chart.transitions[id];
        const bool enabled = std::ranges::all_of(
            transition.from, [&](Id<Chart::Step> step) -> bool { return old.situation[step.index]; });
        if (!enabled) continue;
        const std::optional<std::int64_t> condition = reader.value(transition.condition);
        if (!condition) {
            evolution.fault = RunFault{RunFault::Kind::NoValue, {}, 0, transition.origin};
            return;
        }
        if (*condition != 0) evolution.fired.push_back(id);
    }
}

/// Rules 3 and 5: deactivate, then activate, so that activation wins; a step that was active keeps its age then.
void change_situation(const Chart& chart, const State& old, Evolution& evolution) {
    State& state = evolution.state;
    for (const Id<Chart::Transition> id : evolution.fired)
        for (const Id<Chart::Step> step : chart.transitions[id].from) state.situation[step.index] = false;
    for (const Id<Chart::Transition> id : evolution.fired)
        for (const Id<Chart::Step> step : chart.transitions[id].to) state.situation[step.index] = true;
    for (const Id<Chart::Step> step : chart.steps.ids()) {
        const bool before = old.situation[step.index];
        if (before && !state.situation[step.index]) state.ages[step.index] = -1;
        if (!before && state.situation[step.index]) state.ages[step.index] = 0;
    }
}

/// Runs the stored actions that `triggered` picks. All values are taken before any is stored.
template <class Triggered>
void store(const Chart& chart, Reader& reader, Evolution& evolution, Triggered triggered) {
    std::vector<std::pair<Id<Chart::StoredAction>, std::int64_t>> writes;
    for (const Id<Chart::StoredAction> id : chart.stored.ids()) {
        const Chart::StoredAction& action = chart.stored[id];
        if (!triggered(action)) continue;
        const std::optional<std::int64_t> value = reader.value(action.value);
        if (!value) {
            evolution.fault = RunFault{RunFault::Kind::NoValue, action.target, 0, action.origin};
            return;
        }
        writes.emplace_back(id, *value);
    }
    if (writes.empty()) return;
    std::vector<Id<Chart::StoredAction>> writer(chart.variables.size());
    for (const auto& [id, value] : writes) {
        const Chart::StoredAction& action = chart.stored[id];
        const Type type = chart.variables[action.target].type;
        Id<Chart::StoredAction>& earlier = writer[action.target.index];
        if (earlier.valid() && evolution.state.values[action.target.index] != value && !evolution.race)
            evolution.race = StoredRace{action.target, earlier, id};
        if ((value < type.low || value > type.high) && !evolution.fault)
            evolution.fault = RunFault{RunFault::Kind::OutOfRange, action.target, value, action.origin};
        if (earlier.valid()) continue;
        earlier = id;
        evolution.state.values[action.target.index] = value;
    }
}

}  // namespace

State power_on(const Chart& chart) {
    State state;
    for (const Chart::Step& step : chart.steps) {
        state.situation.push_back(step.initial);
        state.ages.push_back(step.initial ? 0 : -1);
    }
    for (const Chart::Variable& variable : chart.variables) state.values.push_back(variable.initial);
    state.outputs = state.values;
    return state;
}

std::vector<bool> time_conditions(const Chart& chart, const State& state) {
    std::vector<bool> values;
    values.reserve(chart.time_conditions.size());
    for (const Chart::TimeCondition& timed : chart.time_conditions) {
        const auto step = static_cast<std::size_t>(chart.exprs[timed.watched].value);
        values.push_back(state.situation[step] && state.ages[step] >= timed.rise_ms);
    }
    return values;
}

Evolution evolve(const Chart& chart, const State& state, InputValues inputs, const std::vector<bool>& timed) {
    Evolution evolution;
    evolution.state = state;
    evolution.state.started = true;
    Reader reader(chart, state, inputs, &timed);
    if (!state.started) {
        store(chart, reader, evolution, [&](const Chart::StoredAction& action) {
            return action.on == Chart::StoredOn::Activation && state.situation[action.step.index];
        });
        return evolution;
    }
    clear_transitions(chart, state, reader, evolution);
    if (evolution.fault) return evolution;
    evolution.stable = evolution.fired.empty();
    if (evolution.stable) return evolution;
    change_situation(chart, state, evolution);
    store(chart, reader, evolution, [&](const Chart::StoredAction& action) {
        const bool before = state.situation[action.step.index];
        const bool after = evolution.state.situation[action.step.index];
        return action.on == Chart::StoredOn::Activation ? !before && after : before && !after;
    });
    return evolution;
}

std::optional<std::vector<std::int64_t>> output_values(const Chart& chart, const State& state, InputValues inputs) {
    Reader reader(chart, state, inputs, nullptr);
    std::vector<std::int64_t> values(chart.variables.size());
    for (const Id<Chart::Variable> id : chart.variables.ids()) {
        if (chart.variables[id].kind != Chart::VariableKind::Output) continue;
        const std::optional<std::int64_t> value = reader.is_stored(id) ? state.values[id.index] : reader.output(id);
        if (!value) return {};
        values[id.index] = *value;
    }
    return values;
}

namespace {

/// The situations of the loop of `length` evolutions that `state` is on.
std::vector<std::vector<bool>> loop(const Chart& chart, State state, InputValues inputs, std::size_t length) {
    std::vector<std::vector<bool>> situations;
    for (std::size_t k = 0; k < length; ++k) {
        situations.push_back(state.situation);
        state = evolve(chart, state, inputs, time_conditions(chart, state)).state;
    }
    return situations;
}

void write_outputs(const Chart& chart, InputValues inputs, Cycle& result) {
    const auto values = output_values(chart, result.state, inputs);
    if (!values) {
        result.fault = RunFault{RunFault::Kind::NoValue, {}, 0, chart.origin};
        return;
    }
    for (const Id<Chart::Variable> id : chart.variables.ids())
        if (chart.variables[id].kind == Chart::VariableKind::Output)
            result.state.outputs[id.index] = (*values)[id.index];
}

}  // namespace

Cycle cycle(const Chart& chart, const State& state, InputValues inputs, ExecutionMode mode) {
    Cycle result;
    result.state = state;
    // Brent's search for a loop: compare with one state kept, and keep another one after 1, 2, 4, ... evolutions.
    State kept = state;
    std::size_t since_kept = 0;
    std::size_t patience = 1;
    while (true) {
        Evolution evolution = evolve(chart, result.state, inputs, time_conditions(chart, result.state));
        result.state = std::move(evolution.state);
        result.fired.push_back(std::move(evolution.fired));
        result.stable = evolution.stable;
        result.race = evolution.race;
        result.fault = evolution.fault;
        if (result.race || result.fault) return result;
        if (result.stable || mode == ExecutionMode::EveryCycle) break;
        result.gave_up = result.fired.size() == evolution_limit;
        if (result.gave_up) return result;
        ++since_kept;
        if (result.state == kept) {
            result.endless = loop(chart, std::move(kept), inputs, since_kept);
            return result;
        }
        if (since_kept < patience) continue;
        kept = result.state;
        since_kept = 0;
        patience *= 2;
    }
    write_outputs(chart, inputs, result);
    return result;
}

State pass_time(State state, std::int64_t milliseconds) {
    for (std::int64_t& age : state.ages)
        if (age >= 0) age += milliseconds;
    return state;
}

}  // namespace grafverif
