// SPDX-License-Identifier: MIT
// `check`: every property of a closed loop, decided on the spot.
#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <sstream>

#include "app/engines.hpp"
#include "app/outputs.hpp"
#include "app/stop_words.hpp"
#include "app/system/guard.hpp"
#include "app/traces.hpp"
#include "app/verbs.hpp"
#include "pipeline/models.hpp"
#include "report/json.hpp"
#include "report/junit.hpp"
#include "report/terminal.hpp"
#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "support/printable.hpp"

namespace grafverif::app {

namespace {

CheckOptions check_options(const Options& options, const Limits& limits) {
    const bool witnesses = options.verbose || options.format == Format::Json || options.trace_vcd || options.trace_svg;
    return {options.properties, witnesses, options.verbose, limits};
}

/// What the engine asked for finds out; nothing after an error.
std::optional<Report> timed_report(const Model& model, Id<ClosedLoop> id, Job& job, const CheckOptions& options) {
    const auto network = network_of(model, id, job);
    if (!network || !all_known(options.properties, property_names(*network), job.diagnostics)) return {};
    const LoopToCheck loop{*network, charts_of(model, model.loops[id]), !job.options.cures_left_out.empty()};
    return job.options.engine == Engine::Verifyta ? check_by_verifyta(loop, options, job.diagnostics)
                                                  : check(loop, options);
}

/// The program on the PATH that the options ask of untimed models; empty: the embedded engine.
std::string program_of(Engine engine) {
    return engine == Engine::Nusmv ? "NuSMV" : engine == Engine::Nuxmv ? "nuXmv" : "";
}

std::optional<Report> untimed_report(const Model& model, Id<ClosedLoop> id, Job& job, const CheckOptions& options) {
    const ModelOptions how = model_options(job.options);
    const std::string program = program_of(job.options.engine);
    if (program.empty()) return check_untimed(model, id, how, options, job.diagnostics);
    const auto system = transition_system_of(model, id, job);
    if (!system || !all_known(options.properties, property_names(*system), job.diagnostics)) return {};
    const ClosedLoop& loop = model.loops[id];
    return check_by_nusmv({*system, charts_of(model, loop), abstraction_of(how, &loop)}, program, options,
                          job.diagnostics);
}

std::optional<Report> chart_report(const Model& model, Id<Chart> chart, Job& job, const CheckOptions& options) {
    const ModelOptions how = model_options(job.options);
    const std::string program = program_of(job.options.engine);
    if (program.empty()) return check_untimed(model, chart, how, options, job.diagnostics);
    auto system = grafverif::transition_system_of(model, chart, how, job.diagnostics);
    if (system) ask_for_steps(*system);
    if (!system || !all_known(options.properties, property_names(*system), job.diagnostics)) return {};
    return check_by_nusmv({*system, {&model.charts[chart]}, abstraction_of(how, nullptr)}, program, options,
                          job.diagnostics);
}

/// The trace that goes to files: of the first place where the model breaks off, of the first verdict against
/// expectation, of the first that has one.
struct Chosen {
    const ChartRun* trace = nullptr;
    std::string title = {};
};
Chosen first_trace(const Report& report) {
    if (!report.breakdowns.empty() && !report.breakdowns.front().trace.rows.empty())
        return {&report.breakdowns.front().trace, report.model + ": " + report.breakdowns.front().code};
    for (const bool unexpected : {true, false})
        for (const Answer& answer : report.answers)
            if (answer.trace && (!unexpected || !as_expected(answer.verdict)))
                return {&*answer.trace,
                        fmt::format("{}: {} {}", report.model, answer.verdict.property, word(answer.verdict.outcome))};
    return {};
}

void write_reports(const Report& report, Job& job, const Streams& streams) {
    const Options& options = job.options;
    std::vector<OutputFile> files;
    const Chosen chosen = first_trace(report);
    if (chosen.trace) files = trace_files(*chosen.trace, chosen.title, options);
    else if ((options.trace_vcd || options.trace_svg) && !options.quiet)
        streams.err << "note: no verdict has a trace; none was written\n";
    if (options.junit) {
        std::ostringstream text;
        print_junit(report, text);
        files.push_back({*options.junit, std::move(text).str()});
    }
    write_outputs(files, job, streams);
}

void say_who_stopped(Report& report, bool by_user, const Options& options) {
    for (Answer& answer : report.answers)
        if (answer.verdict.obstacle == Obstacle::Stopped)
            answer.verdict.reason = with_who_stopped(std::move(answer.verdict.reason), by_user, options);
}

/// What a loop expects may be about the schedule that it names, which timed models do not have.
void point_to_schedule(const ClosedLoop& loop, const Job& job, const Streams& streams) {
    if (!loop.schedule || job.options.quiet) return;
    streams.err << fmt::format(
        "note: `{}` names a `schedule`, which untimed models alone obey; `grafverif check {} --untimed "
        "--plant automata` checks that one\n",
        loop.name, printable(job.options.operands[0]));
}

ExitCode exit_code(const Report& report, bool stopped) {
    const Tally count = tally(report);
    if (!report.failures.empty()) return ExitCode::Failure;
    if (count.unexpected != 0 || !report.breakdowns.empty()) return ExitCode::Verdict;
    return count.unknown != 0 || stopped ? ExitCode::Unknown : ExitCode::Done;
}

}  // namespace

ExitCode check(Job& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    if (!model) return ExitCode::Input;
    const Bounds bounds(job.options, streams);
    const CheckOptions options = check_options(job.options, bounds.limits());
    std::optional<Report> found;
    std::optional<Id<ClosedLoop>> timed_loop;
    const bool timed = job.options.engine == Engine::Timed || job.options.engine == Engine::Verifyta;
    if (is_of_a_chart(*model, job.options) && !timed) {
        const auto chart = chosen_chart(*model, job);
        if (chart) found = chart_report(*model, *chart, job, options);
        if (found && !job.options.quiet)
            streams.err << "note: `" << model->charts[*chart].name
                        << "` is no closed loop: its steps are checked with free inputs, untimed\n";
    } else if (const auto loop = chosen_loop(*model, job)) {
        if (!job.options.check_untimed) timed_loop = loop;
        found = timed_loop ? timed_report(*model, *loop, job, options) : untimed_report(*model, *loop, job, options);
    }
    if (!found) return ExitCode::Input;
    Report& report = *found;
    say_who_stopped(report, bounds.interrupted(), job.options);
    work_is_done();
    if (job.options.format == Format::Json) print_json(report, streams.out);
    else
        print_report(report,
                     {job.options.verbose, job.options.colour == ColourChoice::Always ? Colour::Ansi : Colour::Plain},
                     streams.out);
    for (const std::string& failure : report.failures)
        streams.err << "grafverif: internal failure: " << printable(failure) << '\n';
    write_reports(report, job, streams);
    const ExitCode code = exit_code(report, bounds.interrupted());
    if (code != ExitCode::Done && timed_loop) point_to_schedule(model->loops[*timed_loop], job, streams);
    return code;
}

Verb check_usage() {
    return {
        "check",
        "FILE",
        1,
        1,
        "prove the properties of a closed loop, with counterexamples in the chart's words",
        "Decides every property of FILE's closed loop with the embedded timed engine, and whether time can stop. "
        "Each verdict\n"
        "says what it rests on; a violated property comes with a trace, replayed on the rules of IEC 60848 first.\n"
        "`--engine verifyta` asks the model checker of UPPAAL instead, where it is on the PATH: verdicts, no traces.\n"
        "With --untimed the model without time is checked, by the embedded symbolic engine or by NuSMV or nuXmv from\n"
        "the PATH; so is a chart that belongs to no loop, with free inputs. What that says of the real plant stands\n"
        "under each verdict.\n"
        "Formats: text, JSON (--format json), JUnit XML (--junit); traces also as VCD and SVG.",
        {"grafverif check samples/testing_station/testing_station.grafcet",
         "grafverif check station.grafcet --property P15 --grain atomic --trace-svg P15.svg",
         "grafverif check station.grafcet --format json --timeout 5min --max-memory 8G",
         "grafverif check samples/tanks/tanks.grafcet --untimed --engine NuSMV",
         "grafverif check samples/assembly_station/assembly_station.grafcet --untimed --plant automata"},
        {Accepts::Search, Accepts::Loop, Accepts::Chart, Accepts::Mode, Accepts::Grain, Accepts::Untimed,
         Accepts::Format, Accepts::Traces, Accepts::Verbose, Accepts::Ablations}};
}

}  // namespace grafverif::app
