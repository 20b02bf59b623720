// SPDX-License-Identifier: MIT
#include "grafverif/ir/chart_run.hpp"

#include <algorithm>
#include <unordered_map>

#include "support/overloaded.hpp"

namespace grafverif {

namespace {

/// True if every id of `list` is in `table`. If `some` is true, invalid ids are allowed.
template <class T>
bool are_in(const std::vector<Id<T>>& list, const Table<T>& table, bool some = false) {
    return std::ranges::all_of(list, [&](Id<T> id) { return id.valid() ? table.contains(id) : some; });
}

bool is_known(const ChartRun& run, const ChartRun::Controller& controller) {
    return are_in(controller.steps, run.steps) && are_in(controller.transitions, run.transitions) &&
           are_in(controller.inputs, run.signals) && are_in(controller.outputs, run.signals) &&
           are_in(controller.internals, run.signals) && are_in(controller.images, run.signals, true) &&
           are_in(controller.timers, run.timers);
}

/// True if `act` refers only to known elements and has the required number of values of inputs and timers.
bool is_known(const ChartRun& run, const ChartRun::Act& act) {
    if (!run.controllers.contains(act.controller)) return false;
    const ChartRun::Controller& controller = run.controllers[act.controller];
    const bool reads = act.samples || act.starts;
    return act.inputs.size() == (reads ? controller.inputs.size() : 0) &&
           act.timers.size() == (act.samples ? controller.timers.size() : 0) &&
           (act.done.empty() || act.done.size() == controller.timers.size()) && are_in(act.fired, run.transitions);
}

void check(const ChartRun& run, const ChartRun::Event& moment, const std::string& where,
           std::vector<std::string>& faults) {
    const std::vector<Id<ChartRun::Step>>& situation = moment.after.situation;
    if (moment.after.values.size() != run.signals.size())
        faults.push_back(where + ": the number of values differs from the number of signals");
    if (!std::ranges::is_sorted(situation, std::ranges::less_equal{}))
        faults.push_back(where + ": the steps of its situation are not sorted");
    if (!are_in(situation, run.steps)) faults.push_back(where + ": its situation has an unknown step");
    const bool known = (!moment.instance.valid() || run.instances.contains(moment.instance)) &&
                       (!moment.timer.valid() || run.timers.contains(moment.timer)) &&
                       are_in(moment.changed, run.signals) &&
                       std::ranges::all_of(moment.acts, [&](const ChartRun::Act& act) { return is_known(run, act); });
    if (!known) faults.push_back(where + ": refers to an unknown element");
}

}  // namespace

bool is_shown(const ChartRun& run, std::size_t index) {
    const bool last = index + 1 == run.rows.size();
    const bool at_loop = run.loop_from && (index == *run.loop_from || index + 1 == *run.loop_from);
    return run.rows[index].kind != ChartRun::Kind::Delay || last || at_loop;
}

std::vector<std::size_t> shown_rows(const ChartRun& run) {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < run.rows.size(); ++i)
        if (is_shown(run, i)) shown.push_back(i);
    return shown;
}

std::vector<Id<ChartRun::Signal>> signals_of(const ChartRun& run, ChartRun::Role role) {
    std::vector<Id<ChartRun::Signal>> found;
    for (const Id<ChartRun::Signal> id : run.signals.ids())
        if (run.signals[id].role == role) found.push_back(id);
    return found;
}

std::vector<std::string> verify(const ChartRun& run) {
    std::vector<std::string> faults;
    for (const ChartRun::Controller& controller : run.controllers)
        if (!is_known(run, controller)) faults.push_back(controller.name + ": refers to an unknown element");
    if (run.moments.empty()) faults.emplace_back("the power-on event is missing");
    std::int64_t time = 0;
    for (std::size_t i = 0; i < run.moments.size(); ++i) {
        const std::string where = "moment " + std::to_string(i);
        check(run, run.moments[i], where, faults);
        if (run.moments[i].after.time_ms < time) faults.push_back(where + ": time decreases");
        time = run.moments[i].after.time_ms;
    }
    std::size_t last_moment = 0;
    for (const ChartRun::Row& row : run.rows) {
        if (row.moment < last_moment || row.moment >= run.moments.size()) faults.emplace_back("a row is out of order");
        for (const std::vector<Id<ChartRun::Transition>>& evolution : row.fired)
            if (!are_in(evolution, run.transitions)) faults.emplace_back("a row clears an unknown transition");
        last_moment = row.moment;
    }
    if (run.loop && (*run.loop == 0 || *run.loop > run.moments.size()))
        faults.emplace_back("the first event of the loop is invalid");
    if (run.loop_from && (*run.loop_from == 0 || *run.loop_from >= run.rows.size()))
        faults.emplace_back("the first row of the loop is invalid");
    for (const ChartRun::Cause& cause : run.causes) {
        const bool known = (!cause.signal.valid() || run.signals.contains(cause.signal)) &&
                           (!cause.step.valid() || run.steps.contains(cause.step)) &&
                           (!cause.instance.valid() || run.instances.contains(cause.instance)) &&
                           (!cause.timer.valid() || run.timers.contains(cause.timer));
        if (!known || cause.first > cause.last || cause.last >= run.moments.size())
            faults.emplace_back("a cause refers to an unknown element or has invalid events");
    }
    if (!run.left_out.empty() && run.left_out.back() >= run.moments.size())
        faults.emplace_back("`left_out` refers to an unknown event");
    for (const ChartRun::Counterfactual& each : run.counterfactual_values)
        if (each.moment >= run.moments.size() ||
            !(each.signal.valid() ? run.signals.contains(each.signal) : run.timers.contains(each.timer)))
            faults.emplace_back("a value in `counterfactual_values` refers to an unknown element");
    return faults;
}

std::string_view word(ChartRun::Kind kind) {
    switch (kind) {
    case ChartRun::Kind::Plant: return "plant";
    case ChartRun::Kind::Environment: return "environment";
    case ChartRun::Kind::Timer: return "timer";
    case ChartRun::Kind::Observer: return "observer";
    case ChartRun::Kind::Controller: return "controller";
    case ChartRun::Kind::Delay: return "delay";
    }
    unreachable();
}

std::string_view word(ChartRun::Role role) {
    switch (role) {
    case ChartRun::Role::Input: return "input";
    case ChartRun::Role::Output: return "output";
    case ChartRun::Role::Internal: return "internal";
    case ChartRun::Role::Image: return "image";
    case ChartRun::Role::Plant: return "plant";
    }
    unreachable();
}

void shorten_names(Table<ChartRun::Step>& steps) {
    std::unordered_map<std::string, int> uses;
    for (const ChartRun::Step& step : steps) ++uses[step.name.step];
    for (ChartRun::Step& step : steps) step.short_name = uses[step.name.step] > 1 ? step.full_name() : step.name.step;
}

std::string event_text(const ChartRun& run, const ChartRun::State& state) {
    return run.timed ? seconds_text(state.time_ms) : std::to_string(state.time_ms);
}

std::string seconds_text(std::int64_t milliseconds) {
    std::string text = std::to_string(milliseconds / 1000);
    if (milliseconds % 1000 != 0) {
        std::string decimals = std::to_string(1000 + milliseconds % 1000).substr(1);
        decimals.erase(decimals.find_last_not_of('0') + 1);
        text += "." + decimals;
    }
    return text + " s";
}

}  // namespace grafverif
