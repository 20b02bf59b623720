// SPDX-License-Identifier: MIT
#include "report/trace_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "report/trace_rows.hpp"
#include "run/project.hpp"
#include "syntax/print/chart.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

std::string instance_text(const ChartRun& run, std::size_t moment, bool inputs) {
    const ChartRun::Event& event = run.moments[moment];
    std::string words;
    if (event.location) words = run.instances[event.instance].locations[*event.location];
    for (const Id<ChartRun::Signal> id : event.changed) {
        const ChartRun::Signal& signal = run.signals[id];
        if (signal.role != ChartRun::Role::Plant && !(inputs && signal.role == ChartRun::Role::Input)) continue;
        if (!words.empty()) words += ", ";
        words += change_text(signal, run.moments[moment - 1].after.values[id.index], event.after.values[id.index]);
    }
    return words;
}

std::string choice_text(const Network& network, const NetworkState& state, const Fire& fire) {
    NetworkState after = state;
    perform(network, after, fire);
    ChartRun run;
    NetworkProjection(network, state, run).append(fire, state, after);
    const Network::Process& process = network.processes[fire.process];
    const Network::Template& automaton = network.templates[process.automaton];
    const std::string words = process.kind == Network::ProcessKind::Controller
                                  ? automaton.locations[automaton.edges[fire.edge].to].name
                                  : instance_text(run, 1, true);
    return words.empty() ? process.name : process.name + ": " + words;
}

namespace {

/// Returns the time condition of a timer, such as `3s/X2`. If the observed term has no name, returns only the duration.
std::string timer_condition(const ChartRun::Timer& timer, bool value = true) {
    if (timer.watched.empty()) return duration_text(value && timer.rise_ms > 0 ? timer.rise_ms : timer.fall_ms);
    return time_text(timer.rise_ms, timer.watched, timer.fall_ms);
}

std::string step_text(const ChartRun::Step& step) {
    return (step.controller.empty() ? "" : step.controller + ".") + step.name.variable();
}

/// Returns the time condition of a timer in the notation of properties. If there are several controllers, the name of
/// the controller qualifies the name of the step.
std::string timer_in_loop(const ChartRun& run, Id<ChartRun::Timer> id) {
    ChartRun::Timer timer = run.timers[id];
    for (const ChartRun::Controller& controller : run.controllers)
        if (timer.step && std::ranges::find(controller.timers, id) != controller.timers.end())
            timer.watched = step_text(run.steps[controller.steps[*timer.step]]);
    return timer_condition(timer);
}

}  // namespace

std::string timer_text(const ChartRun::Timer& timer, bool value) {
    const std::string words = timer_condition(timer, value);
    if (timer.watched.empty()) return words + " are over";
    return words + (value ? " is true" : " is false");
}

std::string value_text(const ChartRun::Signal& signal, std::int64_t value) {
    if (signal.type.boolean) return value != 0 ? signal.name : "!" + signal.name;
    return signal.name + " = " + std::to_string(value);
}

std::string cause_text(const ChartRun& run, const ChartRun::Cause& cause) {
    if (cause.signal.valid()) return value_text(run.signals[cause.signal], cause.value);
    const std::string sign = cause.value != 0 ? "" : "!";
    if (cause.instance.valid()) {
        const ChartRun::Instance& instance = run.instances[cause.instance];
        return sign + instance.name + "." + instance.locations[cause.location];
    }
    if (cause.timer.valid()) return sign + timer_in_loop(run, cause.timer);
    return sign + step_text(run.steps[cause.step]);
}

std::string causes_text(const ChartRun& run) {
    constexpr std::size_t most = 8;
    using Group = std::pair<std::string, std::vector<std::string>>;
    std::vector<Group> groups;  // text of each time or interval, with the texts of its causes
    for (const ChartRun::Cause& cause : run.causes) {
        std::string when = "at " + event_text(run, run.moments[cause.first].after);
        const bool lasts = cause.first < cause.last;
        if (lasts && cause.last + 1 < run.moments.size())
            when = "from" + when.substr(2) + " to " + event_text(run, run.moments[cause.last].after);
        else if (lasts) when = "from" + when.substr(2) + " on";
        auto group = std::ranges::find(groups, when, &Group::first);
        if (group == groups.end()) group = groups.insert(group, {std::move(when), {}});
        // Causes that begin at different events of one instant can have the same text; this text is listed only once.
        std::string text = cause_text(run, cause);
        if (std::ranges::find(group->second, text) == group->second.end()) group->second.push_back(std::move(text));
    }
    std::string text;
    std::size_t count = 0;
    for (const auto& [when, causes] : groups)
        for (std::size_t k = 0; k < causes.size(); ++k) {
            if (++count > most) continue;
            text += k == 0 ? (text.empty() ? "" : "; ") + when + ": " : ", ";
            text += causes[k];
        }
    return count > most ? fmt::format("{}; and {} more", text, count - most) : text;
}

std::string counterfactual_text(const ChartRun& run) {
    std::vector<std::pair<std::size_t, std::string>> all;
    for (const std::size_t moment : run.left_out) {
        const ChartRun::Event& event = run.moments[moment];
        const std::string what = instance_text(run, moment, true);
        all.emplace_back(moment, run.instances[event.instance].name + (what.empty() ? "" : " (" + what + ")"));
    }
    for (const ChartRun::Counterfactual& each : run.counterfactual_values)
        all.emplace_back(each.moment, counterfactual_text(run, each));
    std::ranges::stable_sort(all, {}, [](const auto& each) { return each.first; });
    std::string text;
    for (const auto& [moment, what] : all)
        text += fmt::format("{}{} at {}", text.empty() ? "without " : ", ", what,
                            event_text(run, run.moments[moment].after));
    if (text.empty()) return {};
    return text + " the property holds along the run" +
           (!run.timed && !run.counterfactual_values.empty() ? ", and after its end as long as nothing changes" : "");
}

std::string counterfactual_text(const ChartRun& run, const ChartRun::Counterfactual& left_out) {
    if (left_out.timer.valid()) return timer_condition(run.timers[left_out.timer]);
    return value_text(run.signals[left_out.signal], run.moments[left_out.moment].after.values[left_out.signal.index]);
}

std::string change_text(const ChartRun::Signal& signal, std::int64_t before, std::int64_t after) {
    if (signal.type.boolean) return value_text(signal, after);
    return signal.name + " " + std::to_string(before) + " -> " + std::to_string(after);
}

}  // namespace grafverif
