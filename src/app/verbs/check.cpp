// SPDX-License-Identifier: MIT
// `check`: decides every property of a closed loop with the built-in or external engines.
#include <fmt/format.h>

#include <ostream>
#include <vector>

#include "app/decide.hpp"
#include "app/list_properties.hpp"
#include "app/reports.hpp"
#include "app/system/guard.hpp"
#include "app/traces.hpp"
#include "app/verbs.hpp"
#include "report/json.hpp"
#include "report/terminal.hpp"
#include "report/why.hpp"
#include "support/overloaded.hpp"
#include "support/printable.hpp"

namespace grafverif::app {

namespace {

/// The trace written to files: of the first model error; without one, of the first unexpected verdict; without one, of
/// the first verdict that has a trace.
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

void note_trace(const Report& report, Job& job, const Streams& streams) {
    const Options& options = job.options;
    const Chosen chosen = first_trace(report);
    if (chosen.trace) job.reports->files = trace_files(*chosen.trace, chosen.title, options);
    else if ((options.trace_vcd || options.trace_svg) && !options.quiet)
        streams.err << "note: no verdict has a trace; none was written\n";
}

/// The expected verdicts of a loop may refer to its schedule, which timed models do not have.
void point_to_schedule(const ClosedLoop& loop, const Job& job, const Streams& streams) {
    if (!loop.schedule || job.options.quiet) return;
    streams.err << fmt::format(
        "note: `{}` names a `schedule`, which untimed models alone obey; `grafverif check {} --untimed "
        "--plant automata` checks that one\n",
        loop.name, printable(job.options.operands[0]));
}

/// The models to check in a file, one by one: each loop, and each chart that belongs to none.
struct Aim {
    std::optional<std::string> loop = {}, chart = {};
};

std::vector<Aim> aims(const Model& model, bool all, const Options& asked) {
    if (!all) return {{asked.loop, asked.chart}};
    std::vector<Aim> list;
    for (const ClosedLoop& loop : model.loops) list.push_back({loop.name, {}});
    if (list.empty())
        for (const Chart& chart : model.charts) list.push_back({{}, chart.name});
    return list;
}

ExitCode check_one(const Model& model, Job& job, Bounds& bounds, const Streams& streams) {
    const Options& asked = job.options;
    const bool witnesses = asked.verbose || asked.format == Format::Json || asked.trace_vcd || asked.trace_svg;
    const auto decided = decide(model, job, bounds, witnesses, streams);
    if (!decided) return ExitCode::Input;
    const Report& report = decided->report;
    work_is_done();
    if (asked.format == Format::Json)
        print_json(report, job.sources, streams.out, decided->why ? &*decided->why : nullptr);
    else if (asked.format == Format::JsonLines)
        print_json_lines(report, {job.sources, model, decided->loop, decided->chart}, streams.out);
    else
        print_report(report,
                     {asked.verbose, asked.quiet, colour_on(streams.out_screen, asked), streams.out_screen.columns},
                     streams.out);
    if (decided->why && asked.format == Format::Text && !asked.quiet)
        print_why(*decided->why, asked.verbose, streams.out);
    streams.out.flush();
    for (const std::string& failure : report.failures)
        streams.err << "grafverif: internal failure: " << printable(failure) << '\n';
    note_trace(report, job, streams);
    note(*decided, model, job);
    const ExitCode code = app::exit_code(report, bounds.interrupted());
    if (code != ExitCode::Done && decided->timed) point_to_schedule(model.loops[decided->loop], job, streams);
    return code;
}

}  // namespace

ExitCode check(Job& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    if (!model) return ExitCode::Input;
    if (job.options.list) return list_properties(*model, job, streams);
    Bounds bounds(job.options, streams);
    ExitCode code = ExitCode::Done;
    for (const Aim& aim : aims(*model, job.options.all, job.options)) {
        job.options.loop = aim.loop;
        job.options.chart = aim.chart;
        code = worse(code, check_one(*model, job, bounds, streams));
    }
    return code;
}

Verb check_usage() {
    return {
        "check",
        "FILE...",
        1,
        any_number,
        "prove the properties of a closed loop, with counterexamples in the chart's words",
        "Decides every property of FILE's closed loop with the embedded timed engine, and whether time can stop. "
        "What they\n"
        "rest on is said once; a violated property comes with a trace, replayed on the rules of IEC 60848 first.\n"
        "`--engine verifyta` asks the model checker of UPPAAL instead, where it is on the PATH: verdicts, no traces.\n"
        "With --untimed the model without time is checked, by the embedded symbolic engine or by NuSMV or nuXmv from\n"
        "the PATH; so is a chart that belongs to no loop, with free inputs. What that says of the real plant stands\n"
        "before the verdicts. Of properties about states alone ask `--engine pdr`, embedded, where the states are too "
        "many,\n"
        "and `--engine bmc` for the shortest way to what is wrong, as far as it gets; `--engine auto` looks at cells "
        "by\n"
        "themselves, then asks all three; `--engine abc` and `--engine-command` ask hardware model checkers.\n"
        "Formats: text, JSON (--format json, --json-lines), JUnit XML (--junit), SARIF (--sarif); traces also as VCD "
        "and SVG.\n"
        "Reports are of this run or not there, whatever ends it; docs/how-to/ci.md tells what build servers make of "
        "them.",
        {"grafverif check samples/testing_station/testing_station.grafcet",
         "grafverif check station.grafcet --property P15 --grain atomic --trace-svg P15.svg",
         "grafverif check station.grafcet --format json --timeout 5min --max-memory 8G",
         "grafverif check charts/*.grafcet --all --junit verdicts.xml --sarif verdicts.sarif",
         "grafverif check station.grafcet --list", "grafverif check samples/oven_door/oven_door.grafcet --why",
         "grafverif check samples/tanks/tanks.grafcet --untimed --engine NuSMV",
         "grafverif check samples/assembly_station/assembly_station.grafcet --untimed --plant automata"},
        {Accepts::Search, Accepts::Verdicts, Accepts::All, Accepts::Loop, Accepts::Constants, Accepts::Chart,
         Accepts::Mode, Accepts::Grain, Accepts::Untimed, Accepts::Format, Accepts::Traces, Accepts::Verbose,
         Accepts::Stats, Accepts::Ablations}};
}

}  // namespace grafverif::app
