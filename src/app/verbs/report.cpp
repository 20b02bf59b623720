// SPDX-License-Identifier: MIT
// `report`: results of `check` and `analyse`, drawn charts, plant and equations as one page.
#include "report/report.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "app/decide.hpp"
#include "app/reports.hpp"
#include "app/stop_words.hpp"
#include "app/verbs.hpp"
#include "emit/layout/diagram.hpp"
#include "page/data.hpp"
#include "page/page.hpp"
#include "pipeline/chart_text.hpp"
#include "run/replay_test.hpp"
#include "support/messages.hpp"

namespace grafverif::app {

namespace {

std::vector<Id<Chart>> charts_of(const Model& model, const Decided& decided) {
    if (decided.chart.valid()) return {decided.chart};
    std::vector<Id<Chart>> charts;
    for (const ClosedLoop::Controller& controller : model.loops[decided.loop].controllers)
        charts.push_back(controller.chart);
    return charts;
}

/// The report content of one chart; nothing after an error.
std::optional<ChartContent> content_of(const Model& model, Id<Chart> chart, bool single, Job& job,
                                       const Bounds& bounds) {
    auto equations = equations_of(model, chart, job);
    if (!equations) return {};
    auto analysis = analysis_of(model, chart, job.options.mode, bounds.limits(), job.diagnostics);
    if (!analysis) return {};
    analysis->obstacle = with_who_stopped(std::move(analysis->obstacle), bounds.interrupted(), job.options);
    ChartContent content{.chart = chart, .prefix = single ? "" : model.charts[chart].name + "."};
    const DrawOptions options{.prefix = content.prefix};
    content.drawing = svg_of(drawing_of(model, chart, options, job.sources));
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

/// The runs of the charts in the test of `--sequence`; nothing after an error.
std::optional<std::vector<ChartRun>> tests_of(const Model& model, const std::vector<Id<Chart>>& charts, Job& job) {
    if (charts.size() > 1) {
        std::vector<std::string> names;
        for (const Id<Chart> chart : charts) names.push_back(model.charts[chart].name);
        job.diagnostics.add(messages::ambiguous_choice("chart", "--chart", names));
        return {};
    }
    const auto test = test_sequence(model, charts.front(), job);
    if (!test || job.diagnostics.has_errors()) return {};
    return runs_of(model.charts[charts.front()], *test);
}

std::string warnings_of(const Job& job) {
    std::vector<Diagnostic> warnings;
    for (const Diagnostic& diagnostic : job.diagnostics.all())
        if (diagnostic.severity != Severity::Error) warnings.push_back(diagnostic);
    std::ostringstream text;
    render_text(warnings, job.sources, Colour::Plain, text);
    return std::move(text).str();
}

}  // namespace

ExitCode report(Job& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    if (!model) return ExitCode::Input;
    Bounds bounds(job.options, streams);
    auto decided = decide(*model, job, bounds, true, streams);
    if (!decided) return ExitCode::Input;
    const std::vector<Id<Chart>> charts = charts_of(*model, *decided);
    PageContent content{.model = *model, .sources = job.sources, .loop = decided->loop};
    for (const Id<Chart> chart : charts) {
        auto one = content_of(*model, chart, charts.size() == 1, job, bounds);
        if (!one) return ExitCode::Input;
        content.charts.push_back(std::move(*one));
    }
    if (decided->loop.valid()) content.components = components_of(*model, decided->loop);
    if (job.options.sequence) {
        auto tests = tests_of(*model, charts, job);
        if (!tests) return ExitCode::Input;
        content.tests = std::move(*tests);
    }
    content.file = job.options.operands[0];
    content.version = GRAFVERIF_VERSION;
    content.date = job.options.date;
    content.asked = job.options.properties;
    note(*decided, *model, job);
    content.report = std::move(decided->report);
    content.warnings = warnings_of(job);
    deliver(page_of(content), job, streams);
    const bool faulty =
        std::ranges::any_of(content.charts, [](const ChartContent& chart) { return !chart.analysis.failures.empty(); });
    return faulty ? ExitCode::Failure : exit_code(content.report, bounds.interrupted());
}

Verb report_usage() {
    return {"report",
            "FILE",
            1,
            1,
            "write an HTML report of a loop or chart, with a player for its traces",
            "Writes a self-contained HTML file with the verdicts of `check`, their assumptions, the findings of "
            "`analyse`, the\n"
            "drawn charts, the plant and the equations. A player replays each counterexample, witness and finding on "
            "the chart,\n"
            "and the test sequence of --sequence. A step of a trace has an address: report.html#P16/23.\n"
            "The same input gives the same bytes; the report has a date only with --date. The exit codes are those of "
            "`check`.",
            {"grafverif report samples/testing_station/faulty.grafcet -o report.html",
             "grafverif report station.grafcet --property P15 --date \"$(date -I)\" -o P15.html"},
            {Accepts::Output, Accepts::Search, Accepts::Loop, Accepts::Constants, Accepts::Chart, Accepts::Mode,
             Accepts::Grain, Accepts::Untimed, Accepts::Sequence, Accepts::Date}};
}

}  // namespace grafverif::app
