// SPDX-License-Identifier: MIT
#include "run/interpreter.hpp"

#include <algorithm>
#include <utility>

#include "run/hierarchy.hpp"
#include "run/reader.hpp"

namespace grafverif {

namespace {

/// Applies rules 2 and 4: determines from the old situation all transitions to clear. If the values of conditions are
/// undefined, the first of these conditions is reported as a fault.
std::vector<Id<Chart::Transition>> transitions_to_clear(const Chart& chart, const Levels& levels, const State& old,
                                                        Reader& reader, std::optional<RunFault>& fault) {
    std::vector<Id<Chart::Transition>> cleared;
    for (const Id<Chart::Transition> id : chart.transitions.ids()) {
        const Chart::Transition& transition = chart.transitions[id];
        const bool enabled = std::ranges::all_of(
            transition.from, [&](Id<Chart::Step> step) -> bool { return old.situation[levels.exit(step).index]; });
        if (!enabled || !levels.is_free(transition, old.situation)) continue;
        const std::optional<std::int64_t> condition = reader.value(transition.condition);
        if (!condition) {
            if (!fault) fault = RunFault{RunFault::Kind::NoValue, {}, 0, transition.origin};
            continue;
        }
        if (*condition != 0) cleared.push_back(id);
    }
    return cleared;
}

/// Updates the ages: steps that have become active have age 0, and inactive steps have no age.
void age(const std::vector<bool>& before, State& state) {
    for (std::size_t step = 0; step < before.size(); ++step)
        if (before[step] != state.situation[step]) state.ages[step] = state.situation[step] ? 0 : -1;
}

/// Applies rules 3 and 5: first deactivates steps, then activates steps, so that activation has priority. A step that
/// was already active keeps its age. Finally, the activities of macro-steps, enclosed charts and forced charts are
/// adjusted to the hierarchy.
void change_situation(const Chart& chart, const Levels& levels, const State& old, Evolution& evolution) {
    State& state = evolution.state;
    for (const Id<Chart::Transition> id : evolution.fired)
        for (const Id<Chart::Step> step : chart.transitions[id].from) state.situation[levels.exit(step).index] = false;
    for (const Id<Chart::Transition> id : evolution.fired)
        for (const Id<Chart::Step> step : chart.transitions[id].to) state.situation[levels.entry(step).index] = true;
    state.situation = levels.after(old.situation, state.situation);
    age(old.situation, state);
}

/// Returns true if the evolution executes `action`; empty if the value of its event is undefined.
std::optional<bool> is_triggered(const Chart::StoredAction& action, const State& old, Reader& reader,
                                 const Evolution& evolution) {
    if (action.on == Chart::StoredOn::Clearing)
        return std::ranges::find(evolution.fired, action.transition) != evolution.fired.end();
    const bool before = old.situation[action.step.index];
    const bool after = evolution.state.situation[action.step.index];
    if (!old.started) return action.on == Chart::StoredOn::Activation && before;
    if (action.on == Chart::StoredOn::Activation) return !before && after;
    if (action.on == Chart::StoredOn::Deactivation) return before && !after;
    if (!before) return false;
    const std::optional<std::int64_t> event = reader.value(action.event);
    return event ? std::optional(*event != 0) : std::nullopt;
}

/// Executes the triggered stored actions. All values are evaluated before any value is stored. If an event triggers an
/// action, the situation counts as unstable, because the next evolution may cause further changes.
void store(const Chart& chart, const State& old, Reader& reader, Evolution& evolution) {
    std::vector<std::pair<Id<Chart::StoredAction>, std::int64_t>> writes;
    for (const Id<Chart::StoredAction> id : chart.stored.ids()) {
        const Chart::StoredAction& action = chart.stored[id];
        const std::optional<bool> triggered = is_triggered(action, old, reader, evolution);
        if (triggered == false) continue;
        const std::optional<std::int64_t> value = triggered ? reader.value(action.value) : std::nullopt;
        if (!value) {
            evolution.fault = RunFault{RunFault::Kind::NoValue, action.target, 0, action.origin};
            return;
        }
        writes.emplace_back(id, *value);
        if (action.on == Chart::StoredOn::Event) evolution.stable = false;
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

/// Stores the values of terms before this evolution, which the next evolution compares with the current values to
/// detect edges.
void remember(const Chart& chart, const Memory& memory, Reader& reader, Evolution& evolution) {
    evolution.state.previous.resize(memory.edges.size());
    for (std::size_t place = 0; place < memory.edges.size(); ++place) {
        const std::optional<std::int64_t> now = reader.value(memory.edges[place]);
        if (!now) evolution.fault = RunFault{RunFault::Kind::NoValue, {}, 0, chart.origin};
        evolution.state.previous[place] = now.value_or(0) != 0;
    }
}

/// Starts and stops the timing of observed terms that the evolution has changed. If a term changes at the instant at
/// which its rise time t1 elapses, `ended` determines the order of these two events.
void watch(const Chart& chart, const Memory& memory, const std::vector<bool>& ended, Reader& reader,
           Evolution& evolution) {
    const std::vector<TimedElement> elements = timed_elements(chart);
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const TimedElement& element = elements[k];
        if (k < memory.time_conditions.size() && !memory.time_conditions[k]) continue;
        std::optional<std::int64_t> level;
        if (element.watched.valid()) level = reader.value(element.watched);
        else level = evolution.state.situation[element.step.index];
        if (!level) {
            evolution.fault = RunFault{RunFault::Kind::NoValue, {}, 0, element.origin};
            return;
        }
        Timing& timing = evolution.state.timing[k];
        if ((*level != 0) == (timing.risen >= 0)) continue;
        const bool lasted =
            timing.risen == element.rise_ms ? element.rise_ms == 0 || ended[k] : timing.risen > element.rise_ms;
        if (*level == 0 && lasted) timing.fallen = 0;
        timing.risen = *level != 0 ? 0 : -1;
    }
}

bool holds(const TimedElement& element, const Timing& timing) {
    if (timing.risen >= 0 && timing.risen >= element.rise_ms) return true;
    return timing.fallen >= 0 && timing.fallen < element.fall_ms;
}

}  // namespace

State power_on(const Chart& chart) {
    State state;
    state.situation = Levels(chart).initial();
    for (const bool active : state.situation) state.ages.push_back(active ? 0 : -1);
    for (const Chart::Variable& variable : chart.variables) state.values.push_back(variable.initial);
    state.outputs = state.values;
    state.timing.resize(timed_elements(chart).size());
    return state;
}

std::vector<TimedElement> timed_elements(const Chart& chart) {
    std::vector<TimedElement> elements;
    for (const Chart::TimeCondition& timed : chart.time_conditions)
        elements.push_back({timed.watched, {}, timed.rise_ms, timed.fall_ms, timed.origin});
    for (const Chart::ContinuousAction& action : chart.continuous) {
        if (action.delay_ms > 0) elements.push_back({{}, action.step, action.delay_ms, 0, action.origin});
        if (action.limit_ms > 0)
            elements.push_back({{}, action.step, action.delay_ms + action.limit_ms, 0, action.origin});
    }
    return elements;
}

std::vector<bool> time_conditions(const Chart& chart, const State& state) {
    const std::vector<TimedElement> elements = timed_elements(chart);
    std::vector<bool> values;
    values.reserve(elements.size());
    for (std::size_t k = 0; k < elements.size(); ++k) values.push_back(holds(elements[k], state.timing[k]));
    return values;
}

Evolution evolve(const Chart& chart, const State& state, InputValues inputs, const std::vector<bool>& timed) {
    return evolve(chart, state, inputs, timed, timed);
}

Evolution evolve(const Chart& chart, const State& state, InputValues inputs, const std::vector<bool>& timed,
                 const std::vector<bool>& ended) {
    Evolution evolution;
    evolution.state = state;
    evolution.state.started = true;
    const Memory remembered = memory(chart);
    Reader before(chart, state, inputs, timed, state.started ? &remembered : nullptr);
    const Levels levels(chart);
    if (state.started) {
        evolution.fired = transitions_to_clear(chart, levels, state, before, evolution.fault);
        if (evolution.fault) return evolution;
        // In a further evolution with the same inputs, all edges are false.
        Reader without_edges(chart, state, inputs, timed, nullptr);
        const auto clears_next = [&] {
            return !remembered.edges.empty() &&
                   !transitions_to_clear(chart, levels, state, without_edges, evolution.fault).empty();
        };
        evolution.stable = evolution.fired.empty() && !clears_next();
    }
    if (evolution.fault) return evolution;
    remember(chart, remembered, before, evolution);
    if (!evolution.fired.empty()) change_situation(chart, levels, state, evolution);
    const Id<Chart::ForcingOrder> conflict = levels.conflict(evolution.state.situation);
    if (conflict.valid())
        evolution.fault = RunFault{RunFault::Kind::ForcedApart, {}, 0, chart.forcing[conflict].origin};
    if (evolution.fault) return evolution;
    store(chart, state, before, evolution);
    if (evolution.fault || evolution.race) return evolution;
    Reader after(chart, evolution.state, inputs, timed, &remembered);
    watch(chart, remembered, ended, after, evolution);
    return evolution;
}

std::optional<State> with_situation(const Chart& chart, State state, std::vector<bool> situation, InputValues inputs) {
    const std::vector<bool> timed = time_conditions(chart, state);
    const Memory remembered = memory(chart);
    Evolution by_hand;
    by_hand.state = std::move(state);
    std::swap(by_hand.state.situation, situation);
    age(situation, by_hand.state);
    Reader after(chart, by_hand.state, inputs, timed, &remembered);
    watch(chart, remembered, timed, after, by_hand);
    return by_hand.fault ? std::nullopt : std::optional(std::move(by_hand.state));
}

std::optional<std::vector<std::int64_t>> output_values(const Chart& chart, const State& state, InputValues inputs,
                                                       const std::vector<bool>& timed) {
    Reader reader(chart, state, inputs, timed, nullptr);
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

/// Returns the situations on the cycle of `length` evolutions that contains `state`.
std::vector<std::vector<bool>> loop(const Chart& chart, State state, InputValues inputs, std::size_t length) {
    std::vector<std::vector<bool>> situations;
    for (std::size_t k = 0; k < length; ++k) {
        situations.push_back(state.situation);
        state = evolve(chart, state, inputs, time_conditions(chart, state)).state;
    }
    return situations;
}

void write_outputs(const Chart& chart, InputValues inputs, Cycle& result) {
    const auto values = output_values(chart, result.state, inputs, time_conditions(chart, result.state));
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
    // Brent's cycle detection: each state is compared with a stored state, which is replaced after 1, 2, 4, ...
    // evolutions.
    State kept = state;
    std::size_t since_kept = 0;
    std::size_t power = 1;
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
        if (since_kept < power) continue;
        kept = result.state;
        since_kept = 0;
        power *= 2;
    }
    write_outputs(chart, inputs, result);
    return result;
}

State pass_time(State state, std::int64_t milliseconds) {
    for (std::int64_t& age : state.ages)
        if (age >= 0) age += milliseconds;
    for (Timing& timing : state.timing) {
        if (timing.risen >= 0) timing.risen += milliseconds;
        if (timing.fallen >= 0) timing.fallen += milliseconds;
    }
    return state;
}

}  // namespace grafverif
