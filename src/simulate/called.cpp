// SPDX-License-Identifier: MIT
#include "simulate/called.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace grafverif {

namespace {

/// Returns `name`, qualified by the name of its owner if it has an owner.
std::string within(std::string_view owner, std::string_view name) {
    return owner.empty() ? std::string(name) : fmt::format("{}.{}", owner, name);
}

/// Returns the steps with the complete name `name` or, if there are no such steps, the steps with this name after a
/// qualifier. `before_own` precedes the step name in `name`: `X` if `name` is a step variable, otherwise an empty text.
std::vector<Id<ChartRun::Step>> matching(const ChartRun& run, std::string_view name, std::string_view before_own) {
    std::vector<Id<ChartRun::Step>> whole, shortened;
    for (const ChartRun::Controller& controller : run.controllers)
        for (const Id<ChartRun::Step> id : controller.steps) {
            const StepName& step = run.steps[id].name;
            const std::string own = std::string(before_own) + step.step, partial = within(step.partial, own);
            if (name == within(run.steps[id].controller, partial)) whole.push_back(id);
            const auto spelled = {own, partial, within(controller.name, own), within(controller.name, partial)};
            if (std::ranges::find(spelled, name) != spelled.end()) shortened.push_back(id);
        }
    return whole.empty() ? shortened : whole;
}

}  // namespace

std::vector<Id<ChartRun::Step>> steps_called(const ChartRun& run, std::string_view name) {
    std::vector<Id<ChartRun::Step>> found = matching(run, name, "");
    return found.empty() ? step_variables_called(run, name) : found;
}

std::vector<Id<ChartRun::Step>> step_variables_called(const ChartRun& run, std::string_view name) {
    return matching(run, name, "X");
}

std::vector<Id<ChartRun::Signal>> signals_called(const ChartRun& run, std::string_view name) {
    std::vector<Id<ChartRun::Signal>> found;
    for (const Id<ChartRun::Signal> id : run.signals.ids())
        if (run.signals[id].name == name && run.signals[id].role != ChartRun::Role::Image) return {id};
    for (const Id<ChartRun::Signal> id : run.signals.ids()) {
        const ChartRun::Signal& signal = run.signals[id];
        const std::size_t dot = signal.name.find('.');
        const bool internal = signal.role == ChartRun::Role::Internal;
        std::string in_models = signal.name;
        if (dot != std::string::npos) in_models[dot] = '_';
        const bool is_own = signal.role == ChartRun::Role::Plant && name == in_models;
        const bool is_part = internal && dot != std::string::npos && name == signal.name.substr(dot + 1);
        const bool of_one =
            internal && run.controllers.size() == 1 && name == within(run.controllers.begin()->name, signal.name);
        if (is_own || is_part || of_one) found.push_back(id);
    }
    return found;
}

LocationOfRun location_called(const ChartRun& run, std::string_view name) {
    for (const Id<ChartRun::Instance> id : run.instances.ids())
        for (const std::string& location : run.instances[id].locations)
            if (name == within(run.instances[id].name, location)) return {id, location};
    return {};
}

std::vector<std::string> names_of(const ChartRun& run) {
    std::vector<std::string> names;
    for (const ChartRun::Signal& signal : run.signals)
        if (signal.role != ChartRun::Role::Image) names.push_back(signal.name);
    for (const ChartRun::Step& step : run.steps) names.push_back(variable_of(step));
    return names;
}

std::vector<std::string> instances_of(const ChartRun& run) {
    std::vector<std::string> names;
    for (const ChartRun::Instance& instance : run.instances)
        if (instance.kind == ChartRun::Kind::Plant || instance.kind == ChartRun::Kind::Environment)
            names.push_back(instance.name);
    return names;
}

std::string variable_of(const ChartRun::Step& step) { return within(step.controller, step.name.variable()); }

std::string range_text(std::string_view name, const Type& type, std::int64_t value) {
    if (value >= type.low && value <= type.high) return {};
    if (type.boolean) return fmt::format("`{}` is Boolean and cannot be {}; use true or false", name, value);
    return fmt::format("`{}` ranges from {} to {} and cannot be {}", name, type.low, type.high, value);
}

std::string ambiguous_text(std::string_view name, const std::vector<std::string>& all) {
    return fmt::format("`{}` is ambiguous between `{}` and `{}`; write the qualified name", name, all[0], all[1]);
}

}  // namespace grafverif
