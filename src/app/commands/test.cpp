// SPDX-License-Identifier: MIT
// `test`: checks that an implementation behaves as its chart specifies.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <thread>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "app/progress_line.hpp"
#include "app/reports.hpp"
#include "app/system/interrupt.hpp"
#include "app/system/line_process.hpp"
#include "app/system/watchdog.hpp"
#include "report/test_report.hpp"
#include "run/replay_test.hpp"
#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/dialect.hpp"
#include "syntax/print/scan_line.hpp"

namespace grafverif::app {

namespace {

// Test bench: drives a controller through a test sequence line by line and compares its outputs in every scan (JESA13
// section 6). Each sequence starts the controller again, as at power-on.

struct BenchOptions {
    std::string controller = {};  ///< the shell command that runs the controller
    Clock clock = Clock::Simulated;
    bool keep_going = false;                             ///< continue after a failure if possible
    std::chrono::milliseconds response_timeout{10'000};  ///< time limit for one response
    const std::atomic<bool>* stop = nullptr;             ///< cancellation flag: execute no further step
    std::function<void(std::size_t)> progress = {};      ///< called with the number of completed rows
};

using Cause = TestReport::Cause;
using Failure = TestReport::Failure;

class TestBench {
public:
    TestBench(const TestSequence& test, const BenchOptions& options) : options_(options) {
        report_.test = test;
        report_.controller = options.controller;
        for (const TestSequence::Variable& output : test.outputs) outputs_.push_back({output.name, output.type});
        for (const TestSequence::Sequence& sequence : test.sequences)
            report_.verdicts.emplace_back(rows_of(sequence).size(), StepVerdict::NotRun);
    }

    /// Runs the test. Returns false if the shell did not find the program.
    bool run() {
        const auto start = std::chrono::steady_clock::now();
        for (std::size_t k = 0; k < report_.test.sequences.size() && !stopped(); ++k) {
            if (!run_sequence(k)) return false;
            if (!report_.failures.empty() && !options_.keep_going) break;
        }
        report_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return true;
    }

    TestReport take() { return std::move(report_); }

private:
    /// True for a failure after which the controller cannot be driven further.
    static bool is_fatal(Cause cause) { return cause != Cause::Different && cause != Cause::NotUnderstood; }

    bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }

    bool run_sequence(std::size_t index) {
        LineProcess dialogue(options_.controller,
                             {options_.response_timeout, longest_scan_line(outputs_.size()), options_.stop});
        const std::vector<const TestSequence::Step*> rows = rows_of(report_.test.sequences[index]);
        for (std::size_t row = 0; row < rows.size(); ++row) {
            std::optional<Failure> failure = run_row(dialogue, *rows[row]);
            if (stopped()) return true;
            if (failure && failure->cause == Cause::Ended && done_ == 0 && dialogue.not_found()) return false;
            report_.verdicts[index][row] = failure ? StepVerdict::Failed : StepVerdict::Passed;
            ++done_;
            if (options_.progress) options_.progress(done_);
            if (!failure) continue;
            failure->sequence = index;
            failure->row = row;
            report_.failures.push_back(*failure);
            if (!options_.keep_going || is_fatal(failure->cause)) return true;
        }
        return true;
    }

    /// Returns the first failure of the scans of `step`. The remaining scans are executed only if the test continues
    /// after a failure.
    std::optional<Failure> run_row(LineProcess& dialogue, const TestSequence::Step& step) {
        std::optional<Failure> first;
        if (step.wait_ms != 0) wait(dialogue, step.wait_ms);
        for (std::uint32_t scan = 1; scan <= step.cycles && !stopped(); ++scan) {
            std::optional<Failure> failure = check_response(dialogue, dialogue.request(scan_line(step.inputs)), step);
            if (!failure) continue;
            failure->scan = scan;
            if (!options_.keep_going || is_fatal(failure->cause)) return first ? first : failure;
            if (!first) first = std::move(failure);
        }
        return first;
    }

    /// Waits for `wait_ms`. With `--clock real`, waits slightly longer, because the clock of the controller may tick
    /// less often than the clock of the test bench.
    void wait(LineProcess& dialogue, std::int64_t wait_ms) const {
        if (options_.clock == Clock::Simulated) return dialogue.send("wait " + duration_text(wait_ms));
        constexpr std::chrono::milliseconds margin{20}, nap{50};
        const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(wait_ms) + margin;
        for (auto now = std::chrono::steady_clock::now(); now < end && !stopped();
             now = std::chrono::steady_clock::now())
            std::this_thread::sleep_for(std::min<std::chrono::nanoseconds>(end - now, nap));
    }

    std::optional<Failure> check_response(LineProcess& dialogue, const Reply& answer,
                                          const TestSequence::Step& step) const {
        Failure failure;
        switch (answer.kind) {
        case Reply::Kind::Line: return check_response(answer.text, step);
        case Reply::Kind::Stopped: return {};
        case Reply::Kind::Silent:
            failure.cause = Cause::Silent;
            failure.message = fmt::format("no response within {}", duration_text(options_.response_timeout.count()));
            break;
        case Reply::Kind::Ended:
            failure.cause = Cause::Ended;
            failure.message = "no response: " + dialogue.end_text();
            break;
        case Reply::Kind::Flood:
            failure.cause = Cause::Flood;
            failure.message =
                fmt::format("the controller wrote more than one line for one scan, or an unterminated line: `{}`",
                            shown_line(answer.text));
            break;
        }
        return failure;
    }

    std::optional<Failure> check_response(const std::string& line, const TestSequence::Step& step) const {
        ScanValues read = read_scan_line(line, outputs_);
        if (read.values && *read.values == step.outputs) return {};
        Failure failure;
        if (read.values) failure.answered = std::move(*read.values);
        else {
            failure.cause = Cause::NotUnderstood;
            failure.message =
                fmt::format("the response `{}` is not a line of outputs: {}", shown_line(line), read.problem);
        }
        return failure;
    }

    const BenchOptions& options_;
    TestReport report_ = {};
    std::vector<ScanColumn> outputs_ = {};
    std::size_t done_ = 0;
};

/// Returns the report of the test, or nothing if the shell does not find the program. Throws std::system_error if the
/// program cannot be started.
std::optional<TestReport> run_test(const TestSequence& test, const BenchOptions& options) {
    TestBench bench(test, options);
    if (!bench.run()) return {};
    return bench.take();
}

/// Returns the table given by `--sequence`, or a test generated from the chart.
std::optional<TestSequence> sequence_to_run(const Model& model, Id<Chart> chart, CommandContext& job,
                                            const Limits& limits) {
    if (job.options.sequence) return test_sequence(model, chart, job);
    return test_of(model, chart, conform_options(job.options, limits), job.diagnostics);
}

void write_test_report(const TestReport& report, CommandContext& job, const Streams& streams) {
    const Options& options = job.options;
    work_is_done();
    if (options.format == Format::Json) print_json(report, streams.out);
    else print_text(report, options.quiet, streams.out);
    job.reports->suites = junit_suite(report);
}

std::optional<TestReport> bench_report(const TestSequence& sequence, const Options& options, const Limits& limits) {
    BenchOptions bench{options.against, options.clock, options.keep_going};
    bench.response_timeout = std::chrono::milliseconds(options.response_timeout_ms.value_or(10'000));
    bench.stop = limits.stop;
    bench.progress = [&](std::size_t done) {
        limits.progress({[&] { return fmt::format("{} of {} steps", done, step_count(sequence)); }});
    };
    return run_test(sequence, bench);
}

}  // namespace

ExitCode test(CommandContext& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto chart = model ? chosen_chart(*model, job) : std::nullopt;
    const ResourceLimits bounds(job.options, streams);
    const auto sequence = chart ? sequence_to_run(*model, *chart, job, bounds.limits()) : std::nullopt;
    if (!sequence) return bounds.interrupted() ? ExitCode::Unknown : ExitCode::Input;
    if (const auto wrong = job.options.sequence ? std::nullopt : disagreement(model->charts[*chart], *sequence)) {
        streams.err << "grafverif: internal error: the test fails under the rules of IEC 60848: " << *wrong << '\n';
        return ExitCode::Failure;
    }
    const auto report = bench_report(*sequence, job.options, bounds.limits());
    if (!report) {
        job.diagnostics.add(messages::cannot_run(job.options.against));
        return ExitCode::Input;
    }
    write_test_report(*report, job, streams);
    if (!report->failures.empty()) return ExitCode::Verdict;
    return bounds.interrupted() ? ExitCode::Unknown : ExitCode::Done;
}

CliCommand test_usage() {
    return {
        "test",
        "FILE",
        1,
        1,
        "test an implementation against a chart, scan by scan",
        "Executes a test sequence on the controller PROGRAM and compares its outputs with those of the chart in every\n"
        "scan. PROGRAM is a shell command; for each scan it reads one line of inputs and writes one line of outputs\n"
        "(docs/how-to/test-a-plc.md). Without --sequence, `test` generates the sequence in the same way as `testgen`.\n"
        "Exit code 1: the controller does not conform. Formats: text, JSON, JUnit XML (--junit).",
        {"grafverif test tanks.grafcet --against ./my_controller",
         "grafverif test tanks.grafcet --against ./my_controller --cover evolutions --keep-going --junit report.xml",
         "grafverif test tanks.grafcet --sequence table2.csv --against \"grafverif plc tanks.grafcet --mode "
         "every-cycle\""},
        {OptionGroup::Bench, OptionGroup::Sequence, OptionGroup::Chart, OptionGroup::Mode, OptionGroup::Clock,
         OptionGroup::Format, OptionGroup::Cover, OptionGroup::Minimise}};
}

}  // namespace grafverif::app
