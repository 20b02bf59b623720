// SPDX-License-Identifier: MIT
// Writes a TestReport as text.
#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "report/test_report.hpp"
#include "report/test_words.hpp"
#include "support/overloaded.hpp"
#include "support/printable.hpp"
#include "syntax/print/dialect.hpp"
#include "syntax/print/scan_line.hpp"

namespace grafverif {

namespace {

using Variables = std::vector<TestSequence::Variable>;

/// Returns the variables with their values, such as `s=1 h1=1 h2=0`.
std::string named(const Variables& variables, const std::vector<std::int64_t>& values) {
    std::string text;
    for (std::size_t k = 0; k < variables.size(); ++k)
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", variables[k].name, values[k]);
    return text;
}

std::string names(const Variables& variables) {
    std::string text;
    for (const TestSequence::Variable& variable : variables) text += (text.empty() ? "" : ",") + variable.name;
    return text;
}

/// Returns the waiting time and the number of PLC cycles of a test step, such as `wait 5s, 2 cycles`.
std::string manner(const TestSequence::Step& step) {
    const std::string wait = step.wait_ms == 0 ? "" : "wait " + duration_text(step.wait_ms) + ", ";
    return fmt::format("{}{} cycle{}", wait, step.cycles, step.cycles == 1 ? "" : "s");
}

std::string_view verdict_word(StepVerdict verdict) {
    switch (verdict) {
    case StepVerdict::Passed: return "passed";
    case StepVerdict::Failed: return "FAILED";
    case StepVerdict::NotRun: return "not run";
    }
    unreachable();
}

void print_rows(const TestReport& report, bool failures_only, std::ostream& out) {
    const TestSequence& test = report.test;
    for_each_row(report, [&](std::size_t sequence, std::size_t row, const TestReport::Failure* failure) {
        if (failures_only && failure == nullptr) return;
        const TestSequence::Step& step = *rows_of(test.sequences[sequence])[row];
        out << fmt::format("{}: {} -> {}, {}: {}\n", row_name(test, sequence, row), scan_line(step.inputs),
                           scan_line(step.outputs), manner(step), verdict_word(report.verdicts[sequence][row]));
        if (failure != nullptr) out << failure_text(report, *failure);
    });
}

}  // namespace

std::string_view mode_word(ExecutionMode mode) {
    return mode == ExecutionMode::StabilitySearch ? "stability-search" : "every-cycle";
}

std::string cause_text(const TestReport& report, const TestReport::Failure& failure) {
    if (failure.cause != TestReport::Cause::Different) return failure.message;
    const TestSequence::Step& step = *rows_of(report.test.sequences[failure.sequence])[failure.row];
    std::string differing;
    for (std::size_t k = 0; k < failure.answered.size(); ++k)
        if (failure.answered[k] != step.outputs[k])
            differing += (differing.empty() ? "" : ", ") + report.test.outputs[k].name;
    return "differs in " + differing;
}

std::string failure_text(const TestReport& report, const TestReport::Failure& failure) {
    const TestSequence::Step& step = *rows_of(report.test.sequences[failure.sequence])[failure.row];
    const std::string& situation = report.test.situations[step.situation].text;
    std::string text = fmt::format("    inputs    {}\n    expected  {}{}\n", named(report.test.inputs, step.inputs),
                                   named(report.test.outputs, step.outputs),
                                   situation.empty() ? "" : "   situation " + printable(situation));
    if (!failure.answered.empty())
        text += fmt::format("    observed  {}\n", named(report.test.outputs, failure.answered));
    return text +
           fmt::format("    scan {} of {}: {}\n", failure.scan, step.cycles, printable(cause_text(report, failure)));
}

void print_text(const TestReport& report, bool failures_only, std::ostream& out) {
    const TestTally count = tally(report);
    const std::size_t steps = step_count(report.test);
    const std::size_t sequences = report.test.sequences.size();
    out << fmt::format("{} ({}) against `{}`: {} step{}{}\n", report.test.chart, mode_word(report.test.mode),
                       printable(report.controller), steps, steps == 1 ? "" : "s",
                       sequences == 1 ? "" : fmt::format(" in {} sequences, each starting at power-on", sequences));
    if (!failures_only)
        out << fmt::format("inputs {} -> outputs {}\n", names(report.test.inputs), names(report.test.outputs));
    print_rows(report, failures_only, out);
    out << fmt::format("{}: {} passed, {} failed, {} not run\n",
                       count.failed != 0    ? "does not conform"
                       : count.not_run != 0 ? "incomplete"
                                            : "passes the complete test",
                       count.passed, count.failed, count.not_run);
}

}  // namespace grafverif
