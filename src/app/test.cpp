// SPDX-License-Identifier: MIT
// `test`: does an implementation do what the chart says?
#include <fmt/format.h>

#include <chrono>
#include <ostream>
#include <sstream>

#include "app/bench.hpp"
#include "app/files.hpp"
#include "app/interrupt.hpp"
#include "app/verbs.hpp"
#include "grafverif/support/messages.hpp"

namespace grafverif::app {

namespace {

/// A line on the terminal, written over until the test ends.
class StepCounter {
public:
    StepCounter(const Streams& streams, bool shown, std::size_t rows) : err_(streams.err), shown_(shown), rows_(rows) {}
    StepCounter(const StepCounter&) = delete;
    StepCounter& operator=(const StepCounter&) = delete;
    ~StepCounter() {
        if (written_) err_ << "\r\x1b[K" << std::flush;
    }

    void show(std::size_t done) {
        const auto now = std::chrono::steady_clock::now();
        if (!shown_ || now - last_ < std::chrono::milliseconds(200)) return;
        last_ = now;
        written_ = true;
        err_ << fmt::format("\r{} of {} steps\x1b[K", done, rows_) << std::flush;
    }

private:
    std::ostream& err_;
    bool shown_;
    std::size_t rows_;
    bool written_ = false;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

void write_test_report(const TestReport& report, const Options& options, const Streams& streams) {
    if (options.format == Format::Json) print_json(report, streams.out);
    else print_text(report, options.quiet, streams.out);
    if (!options.junit) return;
    std::ostringstream text;
    print_junit(report, text);
    write_files({{*options.junit, std::move(text).str()}});
}

}  // namespace

ExitCode test(Job& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto chart = model ? chosen_chart(*model, job) : std::nullopt;
    const auto sequence = chart ? test_sequence(*model, *chart, job) : std::nullopt;
    if (!sequence) return ExitCode::Input;

    const Interrupt interrupt;
    StepCounter line(streams, streams.err_is_terminal && !job.options.quiet, step_count(*sequence));
    BenchOptions bench{job.options.against, job.options.clock, job.options.go_on};
    bench.patience = std::chrono::milliseconds(job.options.timeout_ms.value_or(10'000));
    bench.stop = &interrupt.asked();
    bench.progress = [&line](std::size_t done) { line.show(done); };
    const auto report = run_test(*sequence, bench);
    if (!report) {
        job.diagnostics.add(messages::cannot_run(job.options.against));
        return ExitCode::Input;
    }
    write_test_report(*report, job.options, streams);
    if (!report->failures.empty()) return ExitCode::Verdict;
    return interrupt.asked() ? ExitCode::Unknown : ExitCode::Done;
}

Verb test_usage() {
    return {"test",
            "FILE",
            1,
            1,
            "test an implementation against a chart, scan by scan",
            "Runs the controller PROGRAM through a test sequence and compares its outputs with those of the chart in every\n"
            "scan. PROGRAM is a command for the shell; it reads one line of inputs and answers by one line of outputs for each\n"
            "scan (docs/conformance.md). Exit code 1: it does not conform. Formats: text, JSON, JUnit XML (--junit).",
            {"grafverif test tanks.grafcet --sequence samples/tanks/table2.csv --against ./my_controller",
             "grafverif test tanks.grafcet --sequence table2.csv --against \"grafverif plc tanks.grafcet --mode every-cycle\""},
            {Accepts::Bench, Accepts::Sequence, Accepts::Chart, Accepts::Mode, Accepts::Clock, Accepts::Format}};
}

}  // namespace grafverif::app
