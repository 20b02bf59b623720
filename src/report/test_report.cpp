// SPDX-License-Identifier: MIT
// Checks the invariants of a TestReport, and writes it as JSON and JUnit XML.
#include "report/test_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <tuple>

#include "report/test_words.hpp"
#include "support/json_text.hpp"
#include "support/overloaded.hpp"
#include "support/xml_text.hpp"

namespace grafverif {

namespace {

using Json = nlohmann::ordered_json;

std::string_view word(StepVerdict verdict) {
    switch (verdict) {
    case StepVerdict::Passed: return "passed";
    case StepVerdict::Failed: return "failed";
    case StepVerdict::NotRun: return "not run";
    }
    unreachable();
}

std::string_view word(TestReport::Cause cause) {
    switch (cause) {
    case TestReport::Cause::Different: return "different";
    case TestReport::Cause::NotUnderstood: return "not-understood";
    case TestReport::Cause::Silent: return "silent";
    case TestReport::Cause::Ended: return "ended";
    case TestReport::Cause::Flood: return "flood";
    }
    unreachable();
}

Json values(const std::vector<TestSequence::Variable>& variables, const std::vector<std::int64_t>& list) {
    Json object = Json::object();
    for (std::size_t k = 0; k < variables.size(); ++k)
        object[variables[k].name] = variables[k].type.boolean ? Json(list[k] != 0) : Json(list[k]);
    return object;
}

Json failure(const TestReport& report, const TestReport::Failure* failure) {
    if (failure == nullptr) return nullptr;
    return {{"cause", word(failure->cause)},
            {"scan", failure->scan},
            {"answered", failure->answered.empty() ? Json(nullptr) : values(report.test.outputs, failure->answered)},
            {"message", failure->message.empty() ? Json(nullptr) : Json(failure->message)}};
}

Json step(const TestReport& report, std::size_t sequence, std::size_t row, const TestReport::Failure* failed) {
    const TestSequence::Sequence& steps = report.test.sequences[sequence];
    const TestSequence::Step& step = *rows_of(steps)[row];
    return {{"sequence", sequence + 1},
            {"step", row + (steps.activation ? 0 : 1)},
            {"verdict", word(report.verdicts[sequence][row])},
            {"cycles", step.cycles},
            {"wait_ms", step.wait_ms},
            {"inputs", values(report.test.inputs, step.inputs)},
            {"expected", values(report.test.outputs, step.outputs)},
            {"situation", report.test.situations[step.situation].text},
            {"failure", failure(report, failed)}};
}

}  // namespace

std::vector<const TestSequence::Step*> rows_of(const TestSequence::Sequence& sequence) {
    std::vector<const TestSequence::Step*> rows;
    rows.reserve(sequence.steps.size() + 1);
    if (sequence.activation) rows.push_back(&*sequence.activation);
    for (const TestSequence::Step& step : sequence.steps) rows.push_back(&step);
    return rows;
}

std::string row_name(const TestSequence& test, std::size_t sequence, std::size_t row) {
    const std::string step = fmt::format("step {}", row + (test.sequences[sequence].activation ? 0 : 1));
    return test.sequences.size() == 1 ? step : fmt::format("sequence {}, {}", sequence + 1, step);
}

TestTally tally(const TestReport& report) {
    TestTally count;
    for (const std::vector<StepVerdict>& verdicts : report.verdicts)
        for (const StepVerdict verdict : verdicts)
            ++(verdict == StepVerdict::Passed   ? count.passed
               : verdict == StepVerdict::Failed ? count.failed
                                                : count.not_run);
    return count;
}

std::vector<std::string> verify(const TestReport& report) {
    std::vector<std::string> faults = verify(report.test);
    if (report.verdicts.size() != report.test.sequences.size())
        return {"the number of verdict lists differs from the number of sequences"};
    auto failure = report.failures.begin();
    for (std::size_t k = 0; k < report.verdicts.size(); ++k) {
        if (report.verdicts[k].size() != rows_of(report.test.sequences[k]).size())
            return {"the number of verdicts differs from the number of rows"};
        for (std::size_t row = 0; row < report.verdicts[k].size(); ++row) {
            const bool is_failure = failure != report.failures.end() && failure->sequence == k && failure->row == row;
            if (is_failure != (report.verdicts[k][row] == StepVerdict::Failed))
                faults.push_back("the failures differ from the failed verdicts");
            if (is_failure) ++failure;
        }
    }
    if (failure != report.failures.end()) faults.push_back("a failure refers to a row that does not exist");
    return faults;
}

void print_json(const TestReport& report, std::ostream& out) {
    const TestTally count = tally(report);
    Json steps = Json::array();
    for_each_row(report, [&](std::size_t sequence, std::size_t row, const TestReport::Failure* failed) {
        steps.push_back(step(report, sequence, row, failed));
    });
    const Json document = {{"chart", report.test.chart},
                           {"mode", mode_word(report.test.mode)},
                           {"controller", report.controller},
                           {"verdict", count.failed != 0    ? "failed"
                                       : count.not_run != 0 ? "unknown"
                                                            : "passed"},
                           {"passed", count.passed},
                           {"failed", count.failed},
                           {"not_run", count.not_run},
                           {"seconds", report.seconds},
                           {"steps", std::move(steps)}};
    out << json_text(document) << '\n';
}

std::string junit_suite(const TestReport& report) {
    std::string out;
    const TestTally count = tally(report);
    out += fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\" time=\"{:.3f}\">\n",
        attribute_xml(report.test.chart), count.passed + count.failed + count.not_run, count.failed, count.not_run,
        report.seconds);
    for_each_row(report, [&](std::size_t sequence, std::size_t row, const TestReport::Failure* failed) {
        out += fmt::format("    <testcase classname=\"{}\" name=\"{}\"", attribute_xml(report.test.chart),
                           attribute_xml(row_name(report.test, sequence, row)));
        std::string escaped;
        if (failed != nullptr) escape_xml(failure_text(report, *failed), escaped);
        if (failed != nullptr)
            out += fmt::format(">\n      <failure type=\"{}\" message=\"{}\">{}</failure>\n    </testcase>\n",
                               word(failed->cause), attribute_xml(cause_text(report, *failed)), escaped);
        else if (report.verdicts[sequence][row] == StepVerdict::NotRun) out += ">\n      <skipped/>\n    </testcase>\n";
        else out += "/>\n";
    });
    return out + "  </testsuite>\n";
}

}  // namespace grafverif
