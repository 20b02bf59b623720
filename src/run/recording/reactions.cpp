// SPDX-License-Identifier: MIT
#include "run/recording/reactions.hpp"

#include <utility>

#include "run/scanner.hpp"

namespace grafverif {

namespace {

/// Returns a copy in which each duration is 2, so that 0 (just started), 1 (running) and 2 (elapsed) are distinct.
Chart without_durations(Chart chart) {
    const auto replace = [](std::int64_t& duration) { duration = duration > 0 ? 2 : 0; };
    for (Chart::TimeCondition& timed : chart.time_conditions) {
        replace(timed.rise_ms);
        replace(timed.fall_ms);
    }
    for (Chart::ContinuousAction& action : chart.continuous) {
        replace(action.delay_ms);
        replace(action.limit_ms);
    }
    return chart;
}

void append(std::string& key, std::int64_t value) { append_number(key, static_cast<std::uint64_t>(value)); }

void append(std::string& key, const std::vector<bool>& bits) {
    for (const bool bit : bits) key += bit ? '1' : '0';
}

/// Returns a text that identifies the state. The ages of steps are 0 or -1 and depend on the situation.
std::string key_of(const State& state) {
    std::string key;
    append(key, state.situation);
    for (const std::int64_t value : state.values) append(key, value);
    for (const std::int64_t value : state.outputs) append(key, value);
    append(key, state.previous);
    for (const Timing& timing : state.timing) {
        key += static_cast<char>('0' + timing.risen);
        key += static_cast<char>('0' + timing.fallen);
    }
    key += state.started ? '1' : '0';
    return key;
}

}  // namespace

Reactions::Reactions(const Chart& chart, std::size_t most_bytes)
    : chart_(without_durations(chart)), elements_(timed_elements(chart_)), most_bytes_(most_bytes) {}

StatePointer Reactions::unique(State state) {
    std::string key = key_of(state);
    const std::size_t size = 2 * key.size();  // size of the key and of the state, in bytes
    StatePointer& known = states_[std::move(key)];
    if (known) return known;
    bytes_ += size;
    return known = std::make_shared<const State>(std::move(state));
}

std::shared_ptr<const Reaction> Reactions::react(const StatePointer& before, const std::vector<std::int64_t>& inputs,
                                                 const std::vector<bool>& rise_over,
                                                 const std::vector<bool>& fall_over) {
    std::string key;
    append_number(key, reinterpret_cast<std::uintptr_t>(before.get()));
    for (const std::int64_t value : inputs) append(key, value);
    append(key, rise_over);
    append(key, fall_over);
    if (const auto found = reactions_.find(key); found != reactions_.end()) return found->second;

    if (bytes_ > most_bytes_) {
        reactions_.clear();
        states_.clear();
        bytes_ = 0;
    }
    State state = *before;
    for (std::size_t k = 0; k < elements_.size(); ++k) {
        if (rise_over[k]) state.timing[k].risen = elements_[k].rise_ms;
        if (fall_over[k]) state.timing[k].fallen = -1;
    }
    Cycle result = cycle(chart_, state, inputs, ExecutionMode::StabilitySearch);
    Reaction reaction{.before = before, .fired = result.fired, .problem = problem_in(chart_, result)};
    for (std::size_t k = 0; k < elements_.size(); ++k) {
        Timing& timing = result.state.timing[k];
        reaction.rise_starts.push_back(timing.risen == 0 && elements_[k].rise_ms > 0);
        reaction.fall_starts.push_back(timing.fallen == 0 && elements_[k].fall_ms > 0);
        if (reaction.rise_starts.back()) timing.risen = 1;
        if (timing.fallen == 0) timing.fallen = reaction.fall_starts.back() ? 1 : -1;
    }
    reaction.after = unique(std::move(result.state));
    bytes_ += key.size() + elements_.size();
    for (const auto& evolution : reaction.fired) bytes_ += (evolution.size() + 6) * sizeof(evolution.front());
    return reactions_[std::move(key)] = std::make_shared<const Reaction>(std::move(reaction));
}

}  // namespace grafverif
