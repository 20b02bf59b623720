// SPDX-License-Identifier: MIT
#include "grafverif/ir/trace.hpp"

#include <algorithm>
#include <unordered_map>

#include "grafverif/support/overloaded.hpp"

namespace grafverif {

namespace {

void check_state(const Trace& trace, const Trace::State& state, const std::string& where,
                 std::vector<std::string>& faults) {
    if (state.inputs.size() != trace.inputs.size()) faults.push_back(where + ": its inputs are not those of the trace");
    if (state.outputs.size() != trace.outputs.size())
        faults.push_back(where + ": its outputs are not those of the trace");
    if (state.internals.size() != trace.internals.size())
        faults.push_back(where + ": its internal variables are not those of the trace");
    if (state.plant.size() != trace.plant.size()) faults.push_back(where + ": its plant is not that of the trace");
    if (!std::ranges::is_sorted(state.situation, std::ranges::less_equal{}))
        faults.push_back(where + ": its situation is not in order");
    if (!state.situation.empty() && state.situation.back() >= trace.steps_of_charts.size())
        faults.push_back(where + ": its situation has an unknown step");
}

}  // namespace

bool is_shown(const Trace& trace, std::size_t index) {
    const bool last = index + 1 == trace.steps.size();
    const bool at_loop = trace.loop_from && (index == *trace.loop_from || index + 1 == *trace.loop_from);
    return trace.steps[index].kind != Trace::Kind::Delay || last || at_loop;
}

std::vector<std::size_t> shown_steps(const Trace& trace) {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < trace.steps.size(); ++i)
        if (is_shown(trace, i)) shown.push_back(i);
    return shown;
}

std::vector<std::string> verify(const Trace& trace) {
    std::vector<std::string> faults;
    if (trace.short_names.size() != trace.steps_of_charts.size())
        faults.emplace_back("not every step has a short name");
    if (trace.steps.empty()) faults.emplace_back("the power-on is missing");
    std::int64_t time = 0;
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
        const std::string where = "step " + std::to_string(i);
        check_state(trace, trace.steps[i].after, where, faults);
        if (trace.steps[i].after.time_ms < time) faults.push_back(where + ": time goes back");
        time = trace.steps[i].after.time_ms;
    }
    if (trace.loop_from && (*trace.loop_from == 0 || *trace.loop_from >= trace.steps.size()))
        faults.emplace_back("the loop begins at no step");
    return faults;
}

std::string_view word(Trace::Kind kind) {
    switch (kind) {
        case Trace::Kind::Plant: return "plant";
        case Trace::Kind::Environment: return "environment";
        case Trace::Kind::Timer: return "timer";
        case Trace::Kind::Controller: return "controller";
        case Trace::Kind::Delay: return "delay";
    }
    unreachable();
}

std::vector<std::string> shortened_names(const std::vector<std::string>& names) {
    const auto last_part = [](const std::string& name) { return name.substr(name.rfind('.') + 1); };
    std::unordered_map<std::string, int> uses;
    for (const std::string& name : names) ++uses[last_part(name)];
    std::vector<std::string> list;
    for (const std::string& name : names) list.push_back(uses[last_part(name)] == 1 ? last_part(name) : name);
    return list;
}

std::string moment_text(const Trace& trace, const Trace::State& state) {
    return trace.timed ? seconds_text(state.time_ms) : std::to_string(state.time_ms);
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
