// SPDX-License-Identifier: MIT
// `test`: does an implementation do what the chart says?
#include <fmt/format.h>

#include <chrono>
#include <ostream>
#include <sstream>

#include "app/bench.hpp"
#include "app/guard.hpp"
#include "app/interrupt.hpp"
#include "app/outputs.hpp"
#include "app/progress_line.hpp"
#include "app/verbs.hpp"
#include "grafverif/run/replay_test.hpp"
#include "grafverif/support/messages.hpp"

namespace grafverif::app {

namespace {

/// The table of `--sequence`; or a test made of the chart, which passes on the rules of IEC 60848 before it is run.
std::optional<TestSequence> sequence_to_run(const Model& model, Id<Chart> chart, Job& job, const Streams& streams,
                                            const Interrupt& interrupt) {
    if (job.options.sequence) return test_sequence(model, chart, job);
    const auto machine = mealy_of(model, chart, job, streams, interrupt);
    return machine ? test_of(model, chart, *machine, job) : std::nullopt;
}

void write_test_report(const TestReport& report, Job& job, const Streams& streams) {
    const Options& options = job.options;
    work_is_done();
    if (options.format == Format::Json) print_json(report, streams.out);
    else print_text(report, options.quiet, streams.out);
    if (!options.junit) return;
    std::ostringstream text;
    print_junit(report, text);
    write_outputs({{*options.junit, std::move(text).str()}}, job, streams);
}

std::optional<TestReport> bench_report(const TestSequence& sequence, const Options& options, const Streams& streams,
                                       const Interrupt& interrupt) {
    ProgressLine line(streams.err, streams.err_is_terminal && !options.quiet);
    BenchOptions bench{options.against, options.clock, options.go_on};
    bench.patience = std::chrono::milliseconds(options.patience_ms.value_or(10'000));
    bench.stop = &interrupt.asked();
    bench.progress = [&](std::size_t done) {
        line.show([&] { return fmt::format("{} of {} steps", done, step_count(sequence)); });
    };
    return run_test(sequence, bench);
}

}  // namespace

ExitCode test(Job& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto chart = model ? chosen_chart(*model, job) : std::nullopt;
    const Interrupt interrupt;
    const auto sequence = chart ? sequence_to_run(*model, *chart, job, streams, interrupt) : std::nullopt;
    if (!sequence) return interrupt.asked() ? ExitCode::Unknown : ExitCode::Input;
    if (const auto wrong = job.options.sequence ? std::nullopt : disagreement(model->charts[*chart], *sequence)) {
        streams.err << "grafverif: internal failure: the test does not pass on the rules of IEC 60848: " << *wrong << '\n';
        return ExitCode::Failure;
    }
    const auto report = bench_report(*sequence, job.options, streams, interrupt);
    if (!report) {
        job.diagnostics.add(messages::cannot_run(job.options.against));
        return ExitCode::Input;
    }
    write_test_report(*report, job, streams);
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
            "scan (docs/conformance.md). Without --sequence the test is the one that `testgen` makes of the chart.\n"
            "Exit code 1: the controller does not conform. Formats: text, JSON, JUnit XML (--junit).",
            {"grafverif test tanks.grafcet --against ./my_controller",
             "grafverif test tanks.grafcet --against ./my_controller --cover evolutions --go-on --junit report.xml",
             "grafverif test tanks.grafcet --sequence table2.csv --against \"grafverif plc tanks.grafcet --mode every-cycle\""},
            {Accepts::Bench, Accepts::Sequence, Accepts::Chart, Accepts::Mode, Accepts::Clock, Accepts::Format, Accepts::Cover,
             Accepts::Minimise}};
}

}  // namespace grafverif::app
