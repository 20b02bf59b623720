// SPDX-License-Identifier: MIT
// `check`: every property of a closed loop, decided on the spot. No trace is shown that does not replay on the rules.
#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <sstream>

#include "app/files.hpp"
#include "app/interrupt.hpp"
#include "app/traces.hpp"
#include "app/verbs.hpp"
#include "grafverif/check/timed.hpp"
#include "grafverif/report/json.hpp"
#include "grafverif/report/junit.hpp"
#include "grafverif/report/terminal.hpp"
#include "grafverif/support/messages.hpp"

namespace grafverif::app {

namespace {

/// `1,234,567`
std::string grouped(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
    return text;
}

/// A line on the terminal, written over until the search ends.
class ProgressLine {
public:
    ProgressLine(std::ostream& err, bool shown) : err_(err), shown_(shown) {}
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine() { erase(); }

    void show(const TimedProgress& now) {
        if (!shown_) return;
        erase();
        const double rate = now.seconds > 0 ? static_cast<double>(now.states) / now.seconds / 1e6 : 0;
        const std::string line =
            fmt::format("{} states, {:.2f} million/s, {} to go on from, {} MiB, {:.0f} s", grouped(now.states), rate,
                        grouped(now.queue), now.bytes >> 20U, now.seconds);
        width_ = line.size();
        err_ << line << std::flush;
    }

private:
    void erase() {
        if (width_ != 0) err_ << '\r' << std::string(width_, ' ') << '\r' << std::flush;
        width_ = 0;
    }

    std::ostream& err_;
    bool shown_;
    std::size_t width_ = 0;
};

bool knows_properties(const Network& network, Job& job) {
    std::vector<std::string> known;
    for (const Property& property : network.properties) known.push_back(property.name);
    for (const std::string& name : job.options.properties) {
        if (std::ranges::find(known, name) != known.end()) continue;
        job.diagnostics.add(messages::no_such_choice("property", name, known));
        return false;
    }
    return true;
}

TimedResult search(const Network& network, const Options& options, const Streams& streams, const Interrupt& interrupt) {
    ProgressLine line(streams.err, streams.err_is_terminal && !options.quiet);
    TimedOptions timed;
    timed.properties = options.properties;
    timed.max_states = options.max_states.value_or(timed.max_states);
    timed.max_memory = options.max_memory.value_or(timed.max_memory);
    if (options.timeout_ms)
        timed.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(*options.timeout_ms);
    timed.stop = &interrupt.asked();
    timed.progress = [&line](const TimedProgress& now) { line.show(now); };
    return check_timed(network, timed);
}

/// Turns what the engine found into a report; runs that do not replay are failures and are not told.
class Reporter {
public:
    Reporter(const Network& network, std::vector<const Chart*> charts, const Options& options)
        : network_(network),
          charts_(std::move(charts)),
          detail_(options.verbose ? Detail::Everything : Detail::Chart),
          witnesses_(options.verbose || options.format == Format::Json || options.trace_vcd || options.trace_svg) {}

    Report report(TimedResult result) {
        Report report{network_.name, basis_of(network_, "timed"), {}, {}};
        for (ModelError& error : result.errors) {
            if (!replays(error.run, fmt::format("the way to `{}`", word(error.kind)))) error.run = {};
            report.breakdowns.push_back(breakdown_of(network_, error, detail_));
        }
        for (Verdict& verdict : result.verdicts) {
            if (verdict.outcome == Outcome::Holds && !witnesses_) verdict.run.reset();
            if (verdict.run && !replays(*verdict.run, fmt::format("the trace of `{}`", verdict.property)))
                verdict.run.reset();
            report.answers.push_back(answer_of(network_, std::move(verdict), detail_));
        }
        return report;
    }

    const std::vector<std::string>& failures() const { return failures_; }

private:
    bool replays(const Run& run, const std::string& what) {
        const std::optional<Disagreement> found = disagreement(network_, charts_, run);
        if (found) failures_.push_back(replay_failure(what, *found));
        return !found;
    }

    const Network& network_;
    std::vector<const Chart*> charts_;
    Detail detail_;
    bool witnesses_;  ///< whether anybody looks at them
    std::vector<std::string> failures_ = {};
};

/// The trace that goes to files: of the first place where the model breaks off, of the first verdict against
/// expectation, of the first that has one.
struct Chosen {
    const Trace* trace = nullptr;
    std::string title = {};
};
Chosen first_trace(const Report& report) {
    if (!report.breakdowns.empty())
        return {&report.breakdowns.front().trace, report.model + ": " + report.breakdowns.front().code};
    for (const bool unexpected : {true, false})
        for (const Answer& answer : report.answers)
            if (answer.trace && (!unexpected || !as_expected(answer.verdict)))
                return {&*answer.trace,
                        fmt::format("{}: {} {}", report.model, answer.verdict.property, word(answer.verdict.outcome))};
    return {};
}

void write_reports(const Report& report, const Options& options, const Streams& streams) {
    if (options.junit) {
        std::ostringstream text;
        print_junit(report, text);
        write_files({{*options.junit, std::move(text).str()}});
    }
    if (!options.trace_vcd && !options.trace_svg) return;
    const Chosen chosen = first_trace(report);
    if (chosen.trace) return write_trace_files(*chosen.trace, chosen.title, options);
    if (!options.quiet) streams.err << "note: no verdict has a trace; none was written\n";
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
    const auto loop = model ? chosen_loop(*model, job) : std::nullopt;
    const auto network = loop ? network_of(*model, *loop, job) : std::nullopt;
    if (!network || !knows_properties(*network, job)) return ExitCode::Input;

    const Interrupt interrupt;
    TimedResult result = search(*network, job.options, streams, interrupt);
    Reporter reporter(*network, charts_of(*model, model->loops[*loop]), job.options);
    const Report report = reporter.report(std::move(result));
    if (job.options.format == Format::Json) print_json(report, streams.out);
    else
        print_report(report,
                     {job.options.verbose, job.options.colour == ColourChoice::Always ? Colour::Ansi : Colour::Plain},
                     streams.out);
    for (const std::string& failure : reporter.failures())
        streams.err << "grafverif: internal failure: " << failure << '\n';
    write_reports(report, job.options, streams);
    return exit_code(report, !reporter.failures().empty(), interrupt.asked());
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
            "Formats: text, JSON (--format json), JUnit XML (--junit); traces also as VCD and SVG.",
            {"grafverif check samples/testing_station/testing_station.grafcet",
             "grafverif check station.grafcet --property P15 --grain atomic --trace-svg P15.svg",
             "grafverif check station.grafcet --format json --timeout 5min --max-memory 8G"},
            {Accepts::Search, Accepts::Loop, Accepts::Mode, Accepts::Grain, Accepts::Format, Accepts::Traces,
             Accepts::Verbose}};
}

}  // namespace grafverif::app
