// SPDX-License-Identifier: MIT
// `analyse`: finds possible faults of a chart, and elements that are never used, for all inputs.
#include "pipeline/program/analyse.hpp"

#include <algorithm>
#include <cctype>
#include <ostream>
#include <sstream>

#include "app/commands.hpp"
#include "app/reports.hpp"
#include "app/stop_text.hpp"
#include "app/system/watchdog.hpp"
#include "pipeline/check.hpp"
#include "pipeline/variants/compare_sides.hpp"
#include "read/exclusions.hpp"
#include "read/program/program.hpp"
#include "report/findings.hpp"
#include "support/messages_program.hpp"
#include "support/wording.hpp"

namespace grafverif::app {

namespace {

std::string printed(const Analysis& analysis, const CommandContext& job, const Streams& streams) {
    std::ostringstream out;
    const bool to_file = job.options.output && *job.options.output != "-";
    const Colour colour = colour_on(to_file ? Screen{} : streams.out_screen, job.options);
    switch (job.options.format) {
    case Format::Json: print_findings_json(analysis, job.sources, out); break;
    case Format::Sarif: break;  // written together with the other reports
    case Format::Text:
    case Format::JsonLines:
    case Format::Latex:
    case Format::Xml:
    case Format::Dot:
    case Format::Svg:
    case Format::Csv: print_findings(analysis, job.sources, colour, out); break;
    }
    return std::move(out).str();
}

std::optional<std::vector<Exclusion>> exclusions_of(const Chart& chart, CommandContext& job) {
    if (!job.options.exclusions) return std::vector<Exclusion>{};
    const auto table = read_source(*job.options.exclusions, job);
    if (!table) return {};
    const auto pairs = read_exclusions(*table, job.sources, chart, job.diagnostics);
    if (!pairs) return {};
    std::vector<Exclusion> exclusions;
    for (const ExclusionRow& row : *pairs) exclusions.push_back({row.first, row.second, row.reason, row.origin});
    return exclusions;
}

ExitCode exit_code(const Analysis& analysis) {
    if (!analysis.failures.empty()) return ExitCode::Failure;
    for (const Finding& finding : analysis.findings)
        if (is_open(finding)) return ExitCode::Verdict;
    return analysis.open.empty() ? ExitCode::Done : ExitCode::Unknown;
}

}  // namespace

namespace {

ExitCode finish(Analysis analysis, const ResourceLimits& bounds, CommandContext& job, const Streams& streams) {
    analysis.obstacle = with_who_stopped(std::move(analysis.obstacle), bounds.interrupted(), job.options);
    const std::string text = printed(analysis, job, streams);
    work_is_done();
    if (job.options.output) deliver(text, job, streams);
    else streams.out << text;  // the printed text contains no control characters except colour codes
    if (job.options.sarif) add_findings(analysis, job.sources, job.reports->sarif);
    print_failures(analysis.failures, streams);
    return exit_code(analysis);
}

/// True if `text` contains `word`, which is in capital letters; case is ignored.
bool contains(std::string_view text, std::string_view word) {
    const auto capital = [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); };
    return !std::ranges::search(text, word, {}, capital, capital).empty();
}

ExitCode analyse_program(const Program& program, const std::string& name, CommandContext& job, const Streams& streams) {
    if (job.options.exclusions || job.options.mode) {
        job.diagnostics.add(messages::only_for_charts(program.units[program.main].origin, name,
                                                      "`--exclusions` and `--mode` apply to charts", "remove them"));
        return ExitCode::Input;
    }
    const ResourceLimits bounds(job.options, streams);
    auto analysis = grafverif::analyse_program(program, name, bounds.limits(), job.diagnostics);
    if (!analysis) return ExitCode::Input;
    if (program.retains)
        analysis->notes.emplace_back("power-on is a cold start: retained variables have their initial values");
    return finish(std::move(*analysis), bounds, job, streams);
}

/// Analyses a program that is declared in `model`. If a loop executes the program with another cycle than the interval
/// of its task, the analysis assumes that any time may pass between two scans.
ExitCode analyse_declared(const Model& model, Id<Chart> chart, CommandContext& job, const Streams& streams) {
    Program program = *model.charts[chart].program;
    for (const ClosedLoop& loop : model.loops)
        for (const ClosedLoop::Controller& controller : loop.controllers)
            if (controller.chart == chart && controller.cycle &&
                (controller.cycle->least_ms != program.interval_ms || controller.cycle->most_ms != program.interval_ms))
                program.interval_ms.reset();
    return analyse_program(program, model.charts[chart].name, job, streams);
}

/// Reads the program of a file. The result is empty after an error. If the file contains Sequential Function Charts,
/// the first error has a note about the analysis of these charts.
std::optional<ProgramText> read_program_to_analyse(Id<Source> source, CommandContext& job) {
    Diagnostics found;
    auto program = read_program(source, job.sources, found);
    const std::string& text = job.sources[source].text;
    bool has_hint = program || !(contains(text, "INITIAL_STEP") || contains(text, "<SFC>"));
    for (Diagnostic diagnostic : found.all()) {
        if (diagnostic.severity == Severity::Error && !has_hint) {
            diagnostic.notes.push_back(
                messages::note({}, "`--imported-charts` analyses the Sequential Function Charts of the file"));
            has_hint = true;
        }
        job.diagnostics.add(std::move(diagnostic));
    }
    return program;
}

ExitCode analyse_one(const Model& model, Id<Chart> chart, CommandContext& job, const Streams& streams) {
    if (model.charts[chart].program) return analyse_declared(model, chart, job, streams);
    const auto equations = equations_of(model, chart, job);
    if (!equations) return ExitCode::Input;
    auto exclusions = exclusions_of(model.charts[chart], job);
    if (!exclusions) return ExitCode::Input;

    const ResourceLimits bounds(job.options, streams);
    AnalyseOptions options;
    options.mode = execution_mode(model, chart, job);
    options.exclusions = std::move(*exclusions);
    Analysis analysis = analysis_of(model.charts[chart], *equations, std::move(options), bounds.limits());
    return finish(std::move(analysis), bounds, job, streams);
}

}  // namespace

ExitCode analyse(CommandContext& job, const Streams& streams) {
    const std::string& path = job.options.operands[0];
    const auto source = read_source(path, job);
    if (!source) return ExitCode::Input;
    if (!job.options.imported_charts && contains_program(*source, job.sources)) {
        const auto text = read_program_to_analyse(*source, job);
        if (!text) return ExitCode::Input;
        const Program& program = text->program();
        const Program::Unit& main = program.units[program.main];
        if (job.options.chart || job.options.all) {
            job.diagnostics.add(messages::only_for_charts(main.origin, main.name, "`--chart` and `--all` select charts",
                                                          "remove them, or pass `--imported-charts`"));
            return ExitCode::Input;
        }
        return analyse_program(program, main.name, job, streams);
    }
    const auto model = read_model(*source, path, job);
    if (!model) return ExitCode::Input;
    if (!job.options.all) {
        const auto chart = chosen_chart(*model, job);
        return chart ? analyse_one(*model, *chart, job, streams) : ExitCode::Input;
    }
    ExitCode code = ExitCode::Done;
    for (const Id<Chart> chart : model->charts.ids())
        if (!is_repeated(model->charts[chart])) code = worse(code, analyse_one(*model, chart, job, streams));
    return code;
}

CliCommand analyse_usage() {
    return {
        "analyse",
        "FILE...",
        1,
        any_number,
        "find defects of a chart or PLC program: instability, races, dead transitions, dead statements",
        "Explores all input sequences of a chart and reports its defects, each with a shortest input sequence: total\n"
        "instability; races and conflicts of stored actions; transitions of one divergence cleared together;\n"
        "steps activated while active; partial charts forced twice or forced while enclosed; steps that are never\n"
        "active; transitions that are never or always cleared; outputs that are never set; inputs that are never\n"
        "read. A `constraint` in the chart and a table of input pairs that are never true together (--exclusions)\n"
        "exclude impossible inputs.\n"
        "For a PLC program, reports statements that are never executed, conditions that are always or never true, and\n"
        "outputs that are always assigned twice. Also reports blocks that are never called, timers that never elapse,\n"
        "and run-time faults of the program.\n"
        "`accept CODE \"reason\";` in the chart accepts a finding. Exit code 1: a finding is not accepted; 3: no\n"
        "finding, but the analysis is incomplete (--timeout, --max-memory, Ctrl-C). The output of an incomplete\n"
        "analysis describes what was not analysed.",
        {"grafverif analyse samples/oven_door/oven_door.grafcet",
         "grafverif analyse station.grafcet --chart press --exclusions wiring.csv",
         "grafverif analyse charts/*.grafcet --all --sarif findings.sarif"},
        {OptionGroup::Within, OptionGroup::Output, OptionGroup::All, OptionGroup::Chart, OptionGroup::Mode,
         OptionGroup::Analysis}};
}

}  // namespace grafverif::app
