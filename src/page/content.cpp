// SPDX-License-Identifier: MIT
#include <set>
#include <sstream>
#include <utility>

#include "emit/layout/diagram.hpp"
#include "ir/program/interface.hpp"
#include "page/data.hpp"
#include "page/page.hpp"
#include "pipeline/chart_text.hpp"

namespace grafverif {

namespace {

/// Returns the drawing of a chart or program, without equations and analysis.
ChartContent drawn_chart_content(const Model& model, const Sources& sources, Id<Chart> id, bool single) {
    const Chart& chart = model.charts[id];
    ChartContent content{.chart = id, .prefix = single ? "" : chart.name + "."};
    if (chart.program) content.program = {drawn_chart(chart), listing_of(*chart.program, sources)};
    if (!chart.program || !chart.steps.empty())
        content.drawing = svg_of(drawing_of(model, id, {.prefix = content.prefix}, sources));
    return content;
}

/// Returns the content of the sections about one chart, or nothing after an error.
std::optional<ChartContent> content_of(const Model& model, const Sources& sources, Id<Chart> chart, bool single,
                                       std::optional<ExecutionMode> mode, const Limits& limits,
                                       Diagnostics& diagnostics) {
    ChartContent content = drawn_chart_content(model, sources, chart, single);
    if (content.program) return content;
    auto equations = equations_of(model, chart, diagnostics);
    if (!equations) return {};
    auto analysis = analysis_of(model, chart, mode, limits, diagnostics);
    if (!analysis) return {};
    content.equations = std::move(*equations);
    content.analysis = std::move(*analysis);
    return content;
}

/// Returns the components of the closed loop. A component whose automaton is too large has no drawing.
std::vector<ComponentContent> components_of(const Model& model, Id<ClosedLoop> loop) {
    std::set<Id<Component>> used;
    for (const ClosedLoop::Instance& instance : model.loops[loop].instances) used.insert(instance.component);
    std::vector<ComponentContent> list;
    for (const Id<Component> id : used) {
        std::ostringstream drawing;
        if (const Diagram drawn = diagram(model.components[id]); drawn.nodes.size() <= largest_drawing)
            emit_svg(drawn, drawing, component_figure(id) + "-");
        list.push_back({id, std::move(drawing).str()});
    }
    return list;
}

}  // namespace

PageContent drawn_content(const Model& model, const Sources& sources, Id<ClosedLoop> loop) {
    std::vector<Id<Chart>> charts;
    for (const ClosedLoop::Controller& controller : model.loops[loop].controllers) charts.push_back(controller.chart);
    PageContent content = drawn_charts(model, sources, charts);
    content.loop = loop;
    content.components = components_of(model, loop);
    return content;
}

PageContent drawn_charts(const Model& model, const Sources& sources, const std::vector<Id<Chart>>& charts) {
    PageContent content{.model = model, .sources = sources};
    for (const Id<Chart> chart : charts)
        content.charts.push_back(drawn_chart_content(model, sources, chart, charts.size() == 1));
    return content;
}

std::optional<PageContent> page_content(const Model& model, const Sources& sources, Id<ClosedLoop> loop,
                                        Id<Chart> chart, std::optional<ExecutionMode> mode, const Limits& limits,
                                        Diagnostics& diagnostics) {
    std::vector<Id<Chart>> charts;
    if (!loop.valid()) charts.push_back(chart);
    else
        for (const ClosedLoop::Controller& controller : model.loops[loop].controllers)
            charts.push_back(controller.chart);
    PageContent content{.model = model, .sources = sources, .loop = loop};
    for (const Id<Chart> each : charts) {
        auto one = content_of(model, sources, each, charts.size() == 1, mode, limits, diagnostics);
        if (!one) return {};
        content.charts.push_back(std::move(*one));
    }
    if (loop.valid()) content.components = components_of(model, loop);
    return content;
}

}  // namespace grafverif
