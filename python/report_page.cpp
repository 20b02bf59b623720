// SPDX-License-Identifier: MIT
#include "report_page.hpp"

#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "emit/layout/diagram.hpp"
#include "page/data.hpp"
#include "page/page.hpp"

namespace grafverif::python {

namespace {

std::optional<ChartContent> content_of(const Model& model, Id<Chart> chart, bool single,
                                       std::optional<ExecutionMode> mode, const Limits& limits,
                                       Diagnostics& diagnostics) {
    auto equations = equations_of(model, chart, diagnostics);
    if (!equations) return {};
    auto analysis = analysis_of(model, chart, mode, limits, diagnostics);
    if (!analysis) return {};
    ChartContent content{.chart = chart, .prefix = single ? "" : model.charts[chart].name + "."};
    const DrawOptions options{.prefix = content.prefix};
    content.drawing = svg_of(drawing_of(model, chart, options));
    content.equations = std::move(*equations);
    content.analysis = std::move(*analysis);
    return content;
}

/// The components of the loop, drawn if they are small enough.
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

std::optional<std::string> report_page(const Reading& reading, Id<ClosedLoop> loop, Id<Chart> chart,
                                       const Report& report, std::optional<ExecutionMode> mode, std::string date,
                                       const Limits& limits, Diagnostics& diagnostics) {
    const Model& model = *reading.model;
    std::vector<Id<Chart>> charts;
    if (!loop.valid()) charts.push_back(chart);
    else
        for (const ClosedLoop::Controller& controller : model.loops[loop].controllers)
            charts.push_back(controller.chart);
    PageContent content{.model = model, .sources = reading.sources, .loop = loop};
    for (const Id<Chart> each : charts) {
        auto one = content_of(model, each, charts.size() == 1, mode, limits, diagnostics);
        if (!one) return {};
        content.charts.push_back(std::move(*one));
    }
    if (loop.valid()) content.components = components_of(model, loop);
    if (!reading.sources.empty()) content.file = reading.sources.begin()->name;
    content.version = GRAFVERIF_VERSION;
    content.date = std::move(date);
    content.report = report;
    std::ostringstream warnings;
    render_text(reading.diagnostics.all(), reading.sources, Colour::Plain, warnings);
    content.warnings = std::move(warnings).str();
    return page_of(content);
}

}  // namespace grafverif::python
