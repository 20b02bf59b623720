// SPDX-License-Identifier: MIT
#include "app/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "app/dialogue.hpp"
#include "grafverif/support/overloaded.hpp"
#include "grafverif/syntax/dialect.hpp"
#include "grafverif/syntax/scan_line.hpp"

namespace grafverif::app {

namespace {

using Cause = TestReport::Cause;
using Failure = TestReport::Failure;

class Bench {
public:
    Bench(const TestSequence& test, const BenchOptions& options) : options_(options) {
        report_.test = test;
        report_.controller = options.controller;
        for (const TestSequence::Variable& output : test.outputs) outputs_.push_back({output.name, output.type});
        for (const TestSequence::Sequence& sequence : test.sequences)
            report_.verdicts.emplace_back(rows_of(sequence).size(), StepVerdict::NotRun);
    }

    /// False: the shell found no program.
    bool run() {
        const auto start = std::chrono::steady_clock::now();
        for (std::size_t k = 0; k < report_.test.sequences.size() && !stopped(); ++k) {
            if (!run_sequence(k)) return false;
            if (!report_.failures.empty() && !options_.go_on) break;
        }
        report_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return true;
    }

    TestReport take() { return std::move(report_); }

private:
    /// A failure after which the controller cannot be driven on.
    static bool is_fatal(Cause cause) { return cause != Cause::Different && cause != Cause::NotUnderstood; }

    bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }

    bool run_sequence(std::size_t index) {
        Dialogue dialogue(options_.controller, {options_.patience, longest_scan_line(outputs_.size()), options_.stop});
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
            if (!options_.go_on || is_fatal(failure->cause)) return true;
        }
        return true;
    }

    /// The first failure of the scans of `step`; where the test goes on after it, so do the scans.
    std::optional<Failure> run_row(Dialogue& dialogue, const TestSequence::Step& step) {
        std::optional<Failure> first;
        if (step.wait_ms != 0) wait(dialogue, step.wait_ms);
        for (std::uint32_t scan = 1; scan <= step.cycles && !stopped(); ++scan) {
            std::optional<Failure> failure = judge(dialogue, dialogue.ask(scan_line(step.inputs)), step);
            if (!failure) continue;
            failure->scan = scan;
            if (!options_.go_on || is_fatal(failure->cause)) return first ? first : failure;
            if (!first) first = std::move(failure);
        }
        return first;
    }

    /// A real controller is kept waiting a little longer: its clock may tick less often than ours.
    void wait(Dialogue& dialogue, std::int64_t wait_ms) const {
        if (options_.clock == Clock::Simulated) return dialogue.tell("wait " + duration_text(wait_ms));
        constexpr std::chrono::milliseconds margin{20}, nap{50};
        const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(wait_ms) + margin;
        for (auto now = std::chrono::steady_clock::now(); now < end && !stopped(); now = std::chrono::steady_clock::now())
            std::this_thread::sleep_for(std::min<std::chrono::nanoseconds>(end - now, nap));
    }

    std::optional<Failure> judge(Dialogue& dialogue, const Reply& answer, const TestSequence::Step& step) const {
        Failure failure;
        switch (answer.kind) {
        case Reply::Kind::Line: return judge(answer.text, step);
        case Reply::Kind::Stopped: return {};
        case Reply::Kind::Silent:
            failure.cause = Cause::Silent;
            failure.message = fmt::format("no answer within {}", duration_text(options_.patience.count()));
            break;
        case Reply::Kind::Ended:
            failure.cause = Cause::Ended;
            failure.message = "no answer: " + dialogue.end_text();
            break;
        case Reply::Kind::Flood:
            failure.cause = Cause::Flood;
            failure.message = fmt::format("more than one line for one scan, or one without end: `{}`", shown_line(answer.text));
            break;
        }
        return failure;
    }

    std::optional<Failure> judge(const std::string& line, const TestSequence::Step& step) const {
        ScanValues read = read_scan_line(line, outputs_);
        if (read.values && *read.values == step.outputs) return {};
        Failure failure;
        if (read.values) failure.answered = std::move(*read.values);
        else {
            failure.cause = Cause::NotUnderstood;
            failure.message = fmt::format("the answer `{}` is no line of outputs: {}", shown_line(line), read.problem);
        }
        return failure;
    }

    const BenchOptions& options_;
    TestReport report_ = {};
    std::vector<ScanColumn> outputs_ = {};
    std::size_t done_ = 0;
};

}  // namespace

std::optional<TestReport> run_test(const TestSequence& test, const BenchOptions& options) {
    Bench bench(test, options);
    if (!bench.run()) return {};
    return bench.take();
}

}  // namespace grafverif::app
