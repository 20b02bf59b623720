// SPDX-License-Identifier: MIT
#include "report/report_source.hpp"

#include <algorithm>
#include <string_view>

namespace grafverif {

namespace {

/// True if the span is in a file of the user, and not in the built-in library.
bool is_of_files(const ReportSource& written, Span where) {
    return written.sources.contains(where.source) && !written.sources[where.source].name.starts_with('<');
}

Id<Chart> chart_of(const ReportSource& written, Id<ChartRun::Controller> controller) {
    if (!written.loop.valid()) return written.chart;
    const auto& controllers = written.model.loops[written.loop].controllers;
    return controller.index < controllers.size() ? controllers[{controller.index}].chart : Id<Chart>();
}

/// Returns the position of the chart element that corresponds to `id`, an element of a controller in the run. `list`
/// contains the elements of the controller; `entities` contains the elements of its chart in the same order. Returns
/// null if the chart has no corresponding element.
template <class T, class Entities>
const Span* origin_in(const std::vector<Id<T>>& list, Id<T> id, const Entities& entities) {
    const auto found = std::ranges::find(list, id);
    const auto index = static_cast<std::uint32_t>(found - list.begin());
    return found == list.end() || index >= entities.size() ? nullptr : &entities[{index}].origin;
}

const Span* origin_of(const ReportSource& written, const ChartRun& run, Id<ChartRun::Transition> transition) {
    for (const Id<ChartRun::Controller> id : run.controllers.ids())
        if (const Id<Chart> chart = chart_of(written, id); chart.valid())
            if (const Span* const found =
                    origin_in(run.controllers[id].transitions, transition, written.model.charts[chart].transitions))
                return found;
    return nullptr;
}

/// Returns the position of a step that is active after the row. If the run has several controllers, only steps of the
/// controller of the row are considered. Returns null if no step is active.
const Span* origin_of_situation(const ReportSource& written, const ChartRun& run, const ChartRun::Row& row) {
    for (const Id<ChartRun::Controller> id : run.controllers.ids()) {
        const Id<Chart> chart = chart_of(written, id);
        if (!chart.valid() || (run.controllers.size() > 1 && run.controllers[id].name != row.component)) continue;
        for (const Id<ChartRun::Step> step : run.after(row).situation)
            if (const Span* const found = origin_in(run.controllers[id].steps, step, written.model.charts[chart].steps))
                return found;
    }
    return nullptr;
}

const Span* origin_of_timer(const ReportSource& written, const ChartRun& run, std::size_t moment) {
    const Id<ChartRun::Timer> timer = run.moments[moment].timer;
    for (const Id<ChartRun::Controller> id : run.controllers.ids()) {
        const ChartRun::Controller& controller = run.controllers[id];
        const Id<Chart> chart = chart_of(written, id);
        if (!timer.valid() || !chart.valid() || std::ranges::find(controller.timers, timer) == controller.timers.end())
            continue;
        const std::optional<std::size_t> step = run.timers[timer].step;
        const auto& steps = written.model.charts[chart].steps;
        if (step && *step < steps.size()) return &steps[{static_cast<std::uint32_t>(*step)}].origin;
    }
    return nullptr;
}

const Span* origin_of_instance(const ReportSource& written, std::string_view name) {
    if (!written.loop.valid()) return nullptr;
    const auto& instances = written.model.loops[written.loop].instances;
    const auto found = std::ranges::find(instances, name, &ClosedLoop::Instance::name);
    return found == instances.end() ? nullptr : &found->origin;
}

/// Returns the position of the instance whose component contains the constraint with the property name `property`, such
/// as `Door_constraint_1`; null if the property is not a constraint.
const Span* origin_of_constraint(const ReportSource& written, std::string_view property) {
    const std::size_t name = property.rfind("_constraint_");
    return name == std::string_view::npos ? nullptr : origin_of_instance(written, property.substr(0, name));
}

}  // namespace

Span origin(const ReportSource& written) {
    if (written.loop.valid()) return written.model.loops[written.loop].origin;
    return written.chart.valid() ? written.model.charts[written.chart].origin : Span{};
}

Span origin(const ReportSource& written, const Verdict& verdict) {
    if (is_of_files(written, verdict.origin)) return verdict.origin;
    const Span* const instance = origin_of_constraint(written, verdict.property);
    return instance != nullptr ? *instance : origin(written);
}

Span origin(const ReportSource& written, const ChartRun& run, std::size_t index) {
    while (index > 0 && run.rows[index].kind == ChartRun::Kind::Delay) --index;
    const ChartRun::Row& row = run.rows[index];
    const Span* found = nullptr;
    for (const auto& evolution : row.fired)
        for (const Id<ChartRun::Transition> transition : evolution)
            if (found == nullptr) found = origin_of(written, run, transition);
    if (found == nullptr) found = origin_of_timer(written, run, row.moment);
    if (found == nullptr) found = origin_of_instance(written, row.component);
    if (found == nullptr) found = origin_of_situation(written, run, row);
    return found != nullptr && is_of_files(written, *found) ? *found : origin(written);
}

std::optional<FilePlace> file_place(const Sources& sources, Span where) {
    if (!sources.contains(where.source)) return {};
    const Source& source = sources[where.source];
    return FilePlace{source.name, place(source.text, where.begin)};
}

}  // namespace grafverif
