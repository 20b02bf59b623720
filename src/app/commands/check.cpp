// SPDX-License-Identifier: MIT
// `check`: decides every property of a closed loop with the built-in or external engines.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/decide.hpp"
#include "app/list_properties.hpp"
#include "app/reports.hpp"
#include "app/system/watchdog.hpp"
#include "app/traces.hpp"
#include "ir/task_cycles.hpp"
#include "report/json.hpp"
#include "report/settings_text.hpp"
#include "report/terminal.hpp"
#include "report/why.hpp"
#include "support/overloaded.hpp"
#include "support/printable.hpp"

namespace grafverif::app {

namespace {

/// The trace that is written to files: the trace of the first model error, otherwise of the first
/// unexpected verdict, otherwise of the first verdict with a trace.
struct Chosen {
    const ChartRun* trace = nullptr;
    std::string title = {};
};
Chosen first_trace(const Report& report) {
    if (!report.error_traces.empty() && !report.error_traces.front().trace.rows.empty())
        return {&report.error_traces.front().trace, report.model + ": " + report.error_traces.front().code};
    for (const bool unexpected : {true, false})
        for (const PropertyResult& answer : report.answers)
            if (answer.trace && (!unexpected || !as_expected(answer.verdict)))
                return {&*answer.trace,
                        fmt::format("{}: {} {}", report.model, answer.verdict.property, word(answer.verdict.outcome))};
    return {};
}

void note_trace(const Report& report, CommandContext& job, const Streams& streams) {
    const Options& options = job.options;
    const Chosen chosen = first_trace(report);
    if (chosen.trace) job.reports->files = trace_files(*chosen.trace, chosen.title, options);
    else if ((options.trace_vcd || options.trace_svg) && !options.quiet)
        streams.err << "note: no verdict has a trace, so no trace file was written\n";
}

/// Prints a note if the loop declares a schedule: its expected verdicts may refer to an untimed model, because timed
/// models have no schedule.
void point_to_schedule(const ClosedLoop& loop, const CommandContext& job, const Streams& streams) {
    if (!loop.schedule || job.options.quiet) return;
    streams.err << fmt::format(
        "note: `{}` declares a `schedule`, which applies only to untimed models; to check the untimed model, run "
        "`grafverif check {} --untimed --plant automata`\n",
        loop.name, printable(job.options.operands[0]));
}

/// Names of the loop or chart to check in a file; without names, the only loop or chart is checked.
struct ModelSelection {
    std::optional<std::string> loop = {}, chart = {};
};

/// Returns the models to check: with `--all`, all loops of the file or, if the file has no loop,
/// all charts.
std::vector<ModelSelection> aims(const Model& model, bool all, const Options& requested) {
    if (!all) return {{requested.loop, requested.chart}};
    std::vector<ModelSelection> list;
    for (const ClosedLoop& loop : model.loops) list.push_back({loop.name, {}});
    if (list.empty())
        for (const Chart& chart : model.charts) list.push_back({{}, chart.name});
    return list;
}

/// Returns text such as `set of states: P1, P2`; an empty string if the certificate contains no
/// verdict of this kind.
std::string proved_text(const CertificateSummary& certificate, CertificateKind kind) {
    std::string text;
    for (const CertificateSummary::Certified& one : certificate.certified)
        if (one.kind == kind) text += (text.empty() ? std::string(word(kind)) + ": " : ", ") + printable(one.property);
    return text;
}

/// Records the files of the certificate, and prints which verdicts it contains.
void note_certificate(const Decided& decided, CommandContext& job, const Streams& streams) {
    if (!decided.certificate) return;
    const CertificateSummary& certificate = decided.certificate->summary;
    for (const Certificate::File& file : decided.certificate->files)
        job.reports->files.push_back({std::filesystem::path(certificate.folder) / file.path, file.content});
    if (job.options.format != Format::Text || job.options.quiet) return;
    const std::string checker = decided.timed ? fmt::format("`grafverif-certify {}`", printable(certificate.folder))
                                              : "Certifaiger (NAME.model.aag, NAME.witness.aag) or an LRAT checker "
                                                "(NAME.*.lrat), and runs (NAME.cex) with an AIGER simulator";
    streams.out << fmt::format("certificate: {} of {} verdicts; check it with {}\n", certificate.certified.size(),
                               certificate.certified.size() + certificate.omitted.size(), checker);
    for (const CertificateKind kind : {CertificateKind::States, CertificateKind::Fragment, CertificateKind::Subsystems,
                                       CertificateKind::Run, CertificateKind::WitnessCircuit})
        if (const std::string text = proved_text(certificate, kind); !text.empty()) streams.out << "  " << text << '\n';
    for (const CertificateSummary::Omitted& one : certificate.omitted)
        streams.out << fmt::format("  {} is not certified: {}\n", one.property, one.reason);
}

/// Prints the verdicts in the selected form, and adds them to the requested reports.
ExitCode show(const Decided& decided, const Model& model, CommandContext& job, ResourceLimits& bounds,
              const Streams& streams) {
    const Options& requested = job.options;
    const Report& report = decided.report;
    work_is_done();
    if (requested.format == Format::Json)
        print_json(report, job.sources, streams.out, decided.why ? &*decided.why : nullptr, decided.trials,
                   decided.certificate ? &decided.certificate->summary : nullptr);
    else if (requested.format == Format::JsonLines)
        print_json_lines(report, {job.sources, model, decided.loop, decided.chart}, streams.out);
    else
        print_report(
            report,
            {requested.verbose, requested.quiet, colour_on(streams.out_screen, requested), streams.out_screen.columns},
            streams.out);
    if (decided.why && requested.format == Format::Text && !requested.quiet)
        print_why(*decided.why, requested.verbose, streams.out);
    if (requested.format == Format::Text && !requested.quiet) print_remedies(decided.trials, streams.out);
    streams.out.flush();
    print_failures(report.failures, streams);
    note_trace(report, job, streams);
    note_certificate(decided, job, streams);
    note(decided, model, job);
    const ExitCode code = app::exit_code(report, bounds.interrupted());
    if (code != ExitCode::Done && decided.timed) point_to_schedule(model.loops[decided.loop], job, streams);
    return code;
}

/// Also checks the model with cycle time zero, and adds a note to each verdict that differs with this cycle time.
/// Returns false after an error.
bool compare_with_cycle_zero(Model model, Decided& decided, CommandContext& job, ResourceLimits& bounds,
                             const Streams& streams) {
    remove_task_cycles(model);
    const auto zero = decide(model, job, bounds, false, streams);
    if (!zero) return false;
    for (PropertyResult& answer : decided.report.answers) {
        const auto other = std::ranges::find(zero->report.answers, answer.verdict.property,
                                             [](const PropertyResult& found) { return found.verdict.property; });
        if (other != zero->report.answers.end() && other->verdict.outcome != answer.verdict.outcome)
            answer.verdict.notes.push_back(fmt::format("with cycle time zero: {}", word(other->verdict.outcome)));
    }
    return true;
}

/// Adds the HTML report to the report files, if requested. `chart` is the chart of the report if `decided` is not about
/// a loop. Returns `code` or, after an error, a worse exit code.
ExitCode note_page(const Model& model, const Decided& decided, Id<Chart> chart, ExitCode code, CommandContext& job,
                   const ResourceLimits& bounds) {
    if (!job.options.page) return code;
    auto content = verdict_content(model, decided, chart, job, bounds);
    if (!content) return ExitCode::Input;
    content->report = decided.report;
    content->trials = decided.trials;
    if (has_failed(*content)) code = worse(code, ExitCode::Failure);
    job.reports->files.push_back({*job.options.page, report_page(std::move(*content), job)});
    return code;
}

/// True if the output contains witnesses of properties that hold.
bool shows_witnesses(const Options& options) {
    return options.verbose || options.format == Format::Json || options.trace_vcd || options.trace_svg || options.page;
}

ExitCode check_one(const Model& model, CommandContext& job, ResourceLimits& bounds, const Streams& streams) {
    const Options& requested = job.options;
    auto decided = decide(model, job, bounds, shows_witnesses(requested), streams);
    if (!decided) return ExitCode::Input;
    const bool compares =
        requested.cycle == CycleTime::Both && decided->loop.valid() && has_task_cycle(model.loops[decided->loop]);
    if (compares && !compare_with_cycle_zero(model, *decided, job, bounds, streams)) return ExitCode::Input;
    const ExitCode code = show(*decided, model, job, bounds, streams);
    return note_page(model, *decided, decided->chart, code, job, bounds);
}

/// Checks a PLC program with the properties of a file.
ExitCode check_program(CommandContext& job, const Streams& streams) {
    ResourceLimits bounds(job.options, streams);
    auto checked = decide_program(job, bounds, shows_witnesses(job.options));
    if (!checked) return ExitCode::Input;
    auto& [model, decided] = *checked;
    const Id<Chart> chart = std::exchange(decided.chart, {});  // the output shows the positions in the property file
    const ExitCode code = show(decided, {}, job, bounds, streams);
    return note_page(model, decided, chart, code, job, bounds);
}

}  // namespace

ExitCode check(CommandContext& job, const Streams& streams) {
    if (job.options.property_file) return check_program(job, streams);
    const auto model = read_model(job.options.operands[0], job);
    if (!model) return ExitCode::Input;
    if (job.options.list) return list_properties(*model, job, streams);
    ResourceLimits bounds(job.options, streams);
    ExitCode code = ExitCode::Done;
    for (const ModelSelection& aim : aims(*model, job.options.all, job.options)) {
        job.options.loop = aim.loop;
        job.options.chart = aim.chart;
        code = worse(code, check_one(*model, job, bounds, streams));
    }
    return code;
}

CliCommand check_usage() {
    return {
        "check",
        "FILE...",
        1,
        any_number,
        "check the properties of a closed loop and print counterexamples",
        "Check the properties of a closed loop and print a counterexample for each violation.\n"
        "\n"
        "By default, the timed engine decides every property of the closed loop in FILE, and whether time can stop.\n"
        "The settings and assumptions of the check are printed once, before the verdicts. Each counterexample is\n"
        "replayed under the rules of IEC 60848 before it is printed.\n"
        "\n"
        "Engines for the timed loop (--engine):\n"
        "  timed              embedded, explicit-state (default)\n"
        "  verifyta           UPPAAL's model checker, from the PATH; verdicts without traces\n"
        "\n"
        "Engines for the untimed model (--untimed; also used for a chart without a closed loop, with free inputs):\n"
        "  auto               embedded (default): symbolic, joined after about 1 s by localization, PDR and BMC\n"
        "  symbolic           embedded, decision diagrams\n"
        "  pdr                embedded; state properties of models with very many states\n"
        "  bmc                embedded; shortest counterexamples, up to --max-steps\n"
        "  NuSMV, nuXmv       external, from the PATH\n"
        "  abc                external hardware model checker; --engine-command CMD for others\n"
        "The implication of an untimed verdict for the real plant is printed before the verdicts.\n"
        "\n"
        "If a time or memory limit leaves a property undecided, the property is checked again with other options, for\n"
        "at most a tenth of the time limit (docs/how-to/large-models.md).\n"
        "\n"
        "A closed loop can have PLC programs as controllers: `program NAME = \"FILE\";` (docs/how-to/\n"
        "check-program-with-plant.md).\n"
        "\n"
        "With --properties FILE, each FILE operand is a PLC program (IEC 61131-3) in Structured Text or PLCopen XML.\n"
        "The properties are decided for all input sequences of the program, and counterexamples are replayed by an\n"
        "interpreter of the program. With --why, the statements that each proof depends on are printed.\n"
        "\n"
        "With --certificate DIR, the files in DIR prove the verdicts of a closed loop to the independent program\n"
        "`grafverif-certify DIR` (docs/how-to/certificates.md). With --untimed, the files are circuits, runs\n"
        "and witness circuits in AIGER.\n"
        "\n"
        "Output: text, JSON (--format json, --json-lines), JUnit XML (--junit), SARIF (--sarif), an HTML report like\n"
        "that of `report` (--report); the first trace also as VCD (--trace-vcd) and SVG (--trace-svg). Report files\n"
        "of an earlier run are replaced or removed before the check starts (docs/how-to/ci.md).\n"
        "\n"
        "Exit codes:\n"
        "  0  all verdicts as expected          3  a verdict is unknown, or the check was stopped\n"
        "  1  unexpected verdict, model error   4  internal error\n"
        "  2  invalid input or usage",
        {"grafverif check samples/testing_station/testing_station.grafcet",
         "grafverif check station.grafcet --property P15 --grain atomic --trace-svg P15.svg",
         "grafverif check station.grafcet --format json --timeout 5min --max-memory 8G",
         "grafverif check charts/*.grafcet --all --junit verdicts.xml --sarif verdicts.sarif",
         "grafverif check station.grafcet --list", "grafverif check samples/oven_door/oven_door.grafcet --why",
         "grafverif check samples/tanks/tanks.grafcet --untimed --engine NuSMV",
         "grafverif check samples/assembly_station/assembly_station.grafcet --untimed --plant automata",
         "grafverif check docs/drive.st --properties docs/drive.yaml"},
        {OptionGroup::Within, OptionGroup::Search, OptionGroup::Verdicts, OptionGroup::ProgramProperties,
         OptionGroup::All, OptionGroup::Loop, OptionGroup::Constants, OptionGroup::Chart, OptionGroup::Mode,
         OptionGroup::Grain, OptionGroup::CycleBoth, OptionGroup::Untimed, OptionGroup::Format, OptionGroup::Traces,
         OptionGroup::Verbose, OptionGroup::Stats, OptionGroup::Ablations}};
}

}  // namespace grafverif::app
