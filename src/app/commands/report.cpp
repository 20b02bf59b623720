// SPDX-License-Identifier: MIT
// `report`: writes the results of `check` and `analyse`, drawn charts, plant and equations as one page.
#include "report/report.hpp"

#include "app/commands.hpp"
#include "app/decide.hpp"
#include "app/reports.hpp"
#include "page/page.hpp"
#include "run/replay_test.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"

namespace grafverif::app {

namespace {

/// Returns the runs of a chart, the only element of `charts`, for the test given by `--sequence`; nothing after an
/// error.
std::optional<std::vector<ChartRun>> tests_of(const Model& model, const std::vector<Id<Chart>>& charts,
                                              CommandContext& job) {
    if (charts.size() > 1) {
        std::vector<std::string> names;
        for (const Id<Chart> chart : charts) names.push_back(model.charts[chart].name);
        job.diagnostics.add(messages::ambiguous_choice("chart", "--chart", names));
        return {};
    }
    if (const Chart& chart = model.charts[charts.front()]; chart.program) {
        job.diagnostics.add(messages::only_for_charts(chart.origin, chart.name, "`--sequence` applies only to charts",
                                                      "omit `--sequence`"));
        return {};
    }
    const auto test = test_sequence(model, charts.front(), job);
    if (!test || job.diagnostics.has_errors()) return {};
    return runs_of(model.charts[charts.front()], *test);
}

/// Writes the report of a PLC program that is checked with a property file.
ExitCode report_program(CommandContext& job, const Streams& streams) {
    ResourceLimits bounds(job.options, streams);
    auto checked = decide_program(job, bounds, true);
    if (!checked) return ExitCode::Input;
    auto& [model, decided] = *checked;
    auto content = verdict_content(model, decided, decided.chart, job, bounds);
    if (!content) return ExitCode::Input;
    decided.chart = {};
    note(decided, {}, job);
    content->report = std::move(decided.report);
    const ExitCode code = app::exit_code(content->report, bounds.interrupted());
    deliver(report_page(std::move(*content), job), job, streams);
    return code;
}

}  // namespace

ExitCode report(CommandContext& job, const Streams& streams) {
    if (job.options.property_file) return report_program(job, streams);
    const auto model = read_model(job.options.operands[0], job);
    if (!model) return ExitCode::Input;
    ResourceLimits bounds(job.options, streams);
    auto decided = decide(*model, job, bounds, true, streams);
    if (!decided) return ExitCode::Input;
    auto made = verdict_content(*model, *decided, decided->chart, job, bounds);
    if (!made) return ExitCode::Input;
    PageContent& content = *made;
    std::vector<Id<Chart>> charts;
    for (const ChartContent& one : content.charts) charts.push_back(one.chart);
    if (job.options.sequence) {
        auto tests = tests_of(*model, charts, job);
        if (!tests) return ExitCode::Input;
        content.tests = std::move(*tests);
    }
    note(*decided, *model, job);
    content.report = std::move(decided->report);
    content.trials = std::move(decided->trials);
    const ExitCode code = has_failed(content) ? ExitCode::Failure : exit_code(content.report, bounds.interrupted());
    deliver(report_page(std::move(content), job), job, streams);
    return code;
}

CliCommand report_usage() {
    return {"report",
            "FILE",
            1,
            1,
            "write an HTML report of a loop or chart, with a player for its traces",
            "Writes a self-contained HTML file with the verdicts of `check`, their assumptions, the findings of "
            "`analyse`, the\n"
            "drawn charts, the plant and the equations. A player replays each counterexample, witness and finding on "
            "the chart,\n"
            "and the test sequence of --sequence. For a PLC program, the player shows the statements of each scan with "
            "their\n"
            "values. With --properties FILE, the report is about a PLC program without a plant, as with `check`.\n"
            "Each step of a trace has an address, such as report.html#P16/23.\n"
            "Reports of the same input are byte-identical; a report has a date only with --date. The exit codes are\n"
            "those of `check`.",
            {"grafverif report samples/testing_station/faulty.grafcet -o report.html",
             "grafverif report station.grafcet --property P15 --date \"$(date -I)\" -o P15.html",
             "grafverif report docs/drive.st --properties docs/drive.yaml -o drive.html"},
            {OptionGroup::Output, OptionGroup::Search, OptionGroup::ProgramProperties, OptionGroup::Loop,
             OptionGroup::Constants, OptionGroup::Chart, OptionGroup::Mode, OptionGroup::Grain, OptionGroup::Cycle,
             OptionGroup::Untimed, OptionGroup::Sequence, OptionGroup::Date}};
}

}  // namespace grafverif::app
