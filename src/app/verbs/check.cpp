// SPDX-License-Identifier: MIT
// `check`: every property of a closed loop, decided on the spot.
#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <sstream>

#include "app/engines.hpp"
#include "app/system/guard.hpp"
#include "app/outputs.hpp"
#include "app/stop_words.hpp"
#include "app/traces.hpp"
#include "app/untimed.hpp"
#include "app/verbs.hpp"
#include "report/json.hpp"
#include "report/junit.hpp"
#include "report/terminal.hpp"
#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "support/printable.hpp"

namespace grafverif::app {

namespace {

/// Whether every property asked for is among `known`; one that expands is known by its first part too.
bool knows_properties(const std::vector<std::string>& known, Job& job) {
    for (const std::string& name : job.options.properties) {
        if (std::ranges::any_of(known, [&](const std::string& each) { return is_asked(each, {name}); })) continue;
        job.diagnostics.add(messages::no_such_choice("property", name, known));
        return false;
    }
    return true;
}

std::vector<std::string> property_names(const Table<Property>& properties) {
    std::vector<std::string> names;
    for (const Property& property : properties) names.push_back(property.name);
    return names;
}

/// What the engine asked for finds out; nothing after an error.
std::optional<Findings> findings(const LoopToCheck& loop, Job& job, const Streams& streams, const Interrupt& interrupt) {
    switch (job.options.engine) {
    case Engine::Auto:
    case Engine::Timed:    return check_embedded(loop, job.options, streams, interrupt);
    case Engine::Verifyta: return check_by_verifyta(loop, job, interrupt);
    case Engine::Symbolic: case Engine::Nusmv: case Engine::Nuxmv: break;   // of untimed models
    }
    unreachable();
}

/// The embedded engine alone knows the question, and it has an answer under stability search.
bool asks_for_stability(const Model& model, Id<Chart> chart, const Job& job) {
    return job.options.engine != Engine::Nusmv && job.options.engine != Engine::Nuxmv &&
           execution_mode(model, chart, job) == ExecutionMode::StabilitySearch;
}

/// The same of an untimed model of `model`: of its closed loop, or of a chart alone.
std::optional<Findings> untimed_findings(const Model& model, Job& job, const Streams& streams,
                                         const Interrupt& interrupt) {
    const auto loop = is_of_a_chart(model, job.options) ? std::nullopt : chosen_loop(model, job);
    const auto chart = is_of_a_chart(model, job.options) ? chosen_chart(model, job) : std::nullopt;
    const auto equations = chart ? equations_of(model, *chart, job) : std::nullopt;
    std::optional<TransitionSystem> system;
    if (loop) system = transition_system_of(model, *loop, job);
    if (equations) system = controller_of(model, *chart, *equations, job);
    if (!system) return {};
    if (chart) {
        ask_for_steps(*system);
        if (!job.options.quiet)
            streams.err << "note: `" << model.charts[*chart].name
                        << "` is no closed loop: its steps are checked with free inputs, untimed\n";
    }
    std::vector<std::string> known = property_names(system->properties);
    for (const TransitionSystem::Omitted& omitted : system->omitted) known.push_back(omitted.property.name);
    const bool stability = chart && asks_for_stability(model, *chart, job);
    if (stability) known.emplace_back(stabilises);
    if (!knows_properties(known, job)) return {};
    const ClosedLoop* const of = loop ? &model.loops[*loop] : nullptr;
    const SystemToCheck check{*system, of != nullptr ? charts_of(model, *of) : std::vector{&model.charts[*chart]},
                              abstraction_of(job.options, of)};
    if (job.options.engine == Engine::Nusmv) return check_by_nusmv(check, "NuSMV", job, interrupt);
    if (job.options.engine == Engine::Nuxmv) return check_by_nusmv(check, "nuXmv", job, interrupt);
    Findings found = check_symbolically(check, job.options, streams, interrupt);
    const bool asked = job.options.properties.empty() || is_asked(stabilises, job.options.properties);
    if (stability && asked)
        add_stabilises(model.charts[*chart], *equations, job.options, interrupt, found);
    return found;
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
    else if ((options.trace_vcd || options.trace_svg) && !options.quiet) streams.err << "note: no verdict has a trace; none was written\n";
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
    streams.err << fmt::format("note: `{}` names a `schedule`, which untimed models alone obey; `grafverif check {} --untimed "
                               "--plant automata` checks that one\n",
                               loop.name, printable(job.options.operands[0]));
}

ExitCode exit_code(const Report& report, bool failed, bool stopped) {
    const Tally count = tally(report);
    if (failed) return ExitCode::Failure;
    if (count.unexpected != 0 || !report.breakdowns.empty()) return ExitCode::Verdict;
    return count.unknown != 0 || stopped ? ExitCode::Unknown : ExitCode::Done;
}

}  // namespace

ExitCode check(Job& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    if (!model) return ExitCode::Input;
    const Interrupt interrupt;
    std::optional<Findings> found;
    std::optional<Id<ClosedLoop>> timed_loop;
    const bool timed = job.options.engine == Engine::Timed || job.options.engine == Engine::Verifyta;
    if (job.options.check_untimed || (is_of_a_chart(*model, job.options) && !timed)) {
        found = untimed_findings(*model, job, streams, interrupt);
    } else {
        const auto loop = chosen_loop(*model, job);
        const auto network = loop ? network_of(*model, *loop, job) : std::nullopt;
        if (network && knows_properties(property_names(network->properties), job))
            found = findings({*network, charts_of(*model, model->loops[*loop])}, job, streams, interrupt);
        timed_loop = loop;
    }
    if (!found) return ExitCode::Input;
    Report& report = found->report;
    say_who_stopped(report, interrupt.asked(), job.options);
    work_is_done();
    if (job.options.format == Format::Json) print_json(report, streams.out);
    else
        print_report(report,
                     {job.options.verbose, job.options.colour == ColourChoice::Always ? Colour::Ansi : Colour::Plain},
                     streams.out);
    for (const std::string& failure : found->failures)
        streams.err << "grafverif: internal failure: " << printable(failure) << '\n';
    write_reports(report, job, streams);
    const ExitCode code = exit_code(report, !found->failures.empty(), interrupt.asked());
    if (code != ExitCode::Done && timed_loop) point_to_schedule(model->loops[*timed_loop], job, streams);
    return code;
}

Verb check_usage() {
    return {"check",
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
            {Accepts::Search, Accepts::Loop, Accepts::Chart, Accepts::Mode, Accepts::Grain, Accepts::Untimed, Accepts::Format,
             Accepts::Traces, Accepts::Verbose, Accepts::Ablations}};
}

}  // namespace grafverif::app
