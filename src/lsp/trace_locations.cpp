// SPDX-License-Identifier: MIT
#include "lsp/trace_locations.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/trace_text.hpp"
#include "support/printable.hpp"

namespace grafverif::lsp {

namespace {

constexpr std::size_t most_rows = 60;

std::string happening(const ChartRun& run, const ChartRun::Row& row) {
    std::string text = event_text(run, run.after(row)) + ": ";
    if (!row.component.empty()) text += row.component + " ";
    const bool moves = row.kind == ChartRun::Kind::Plant || row.kind == ChartRun::Kind::Environment;
    text += moves ? instance_text(run, row.moment, true) : row.what;
    for (const auto& evolution : row.fired)
        for (const Id<ChartRun::Transition> transition : evolution)
            text += fmt::format("{}{}", text.ends_with(' ') ? "clears " : ", ", run.transitions[transition].name);
    if (row.kind == ChartRun::Kind::Controller) {
        text += "; active:";
        for (const Id<ChartRun::Step> step : run.after(row).situation) text += " " + run.steps[step].short_name;
    }
    return printable(text);
}

}  // namespace

const Chart* TraceLocations::chart_named(const std::string& name) const {
    if (chart_.valid()) return &model_.charts[chart_];
    for (const ClosedLoop::Controller& controller : model_.loops[loop_].controllers)
        if (controller.name == name || model_.loops[loop_].controllers.size() == 1)
            return &model_.charts[controller.chart];
    return nullptr;
}

/// Returns the source position of a row. The result is invalid if the row has no source position.
Span TraceLocations::origin_of(const ChartRun& run, const ChartRun::Row& row) const {
    if (loop_.valid())
        for (const ClosedLoop::Instance& instance : model_.loops[loop_].instances)
            if (instance.name == row.component) return instance.origin;
    const Chart* const chart = chart_named(row.component);
    if (chart == nullptr || row.kind == ChartRun::Kind::Delay) return {};
    for (const auto& evolution : row.fired)
        for (const Id<ChartRun::Transition> fired : evolution)
            for (const Chart::Transition& transition : chart->transitions)
                if (run.transitions[fired].name == transition.name ||
                    run.transitions[fired].name.ends_with("." + transition.name))
                    return transition.origin;
    for (const Id<ChartRun::Step> active : run.after(row).situation)
        for (const Chart::Step& step : chart->steps)
            if (run.steps[active].name.step == step.name) return step.origin;
    return chart->origin;
}

std::vector<Related> TraceLocations::of(const ChartRun& run) const {
    std::vector<Related> places;
    const std::vector<std::size_t> rows = shown_rows(run);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (rows.size() > most_rows && k >= most_rows / 2 && k < rows.size() - most_rows / 2) continue;
        const ChartRun::Row& row = run.rows[rows[k]];
        const Span where = origin_of(run, row);
        if (!where.source.valid()) continue;
        std::string text = happening(run, row);
        if (run.loop_from == rows[k]) text += " (repeated forever from here)";
        places.push_back({places_.of(where), std::move(text)});
    }
    return places;
}

}  // namespace grafverif::lsp
