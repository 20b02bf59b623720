// SPDX-License-Identifier: MIT
#include "report/junit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "report/terminal.hpp"
#include "support/xml_text.hpp"

namespace grafverif {

namespace {

std::string data(std::string_view text) {
    std::string xml;
    escape_xml(text, xml);
    return xml;
}

std::string run_text(const ChartRun& run, std::string_view end) {
    std::ostringstream text;
    print_trace(run, text);
    if (!run.loop_from && !end.empty()) text << "    " << end << '\n';
    return std::move(text).str();
}

/// Returns the first lines of `text`, for the message of a failure. Build servers show only the message until the user
/// expands the failure.
std::string first_lines(std::string_view text) {
    constexpr std::size_t shown = 6;
    std::size_t end = 0;
    for (std::size_t line = 0; line < shown && end != std::string_view::npos; ++line) end = text.find('\n', end + 1);
    if (end == std::string_view::npos || end + 1 >= text.size()) return std::string(text);
    return std::string(text.substr(0, end)) + "\n...";
}

/// Returns the XML element of a test case that did not pass: `<failure ...>`, `<error ...>` or `<skipped ...>`.
std::string element(std::string_view name, std::string_view type, std::string_view message, std::string_view content) {
    const std::string kind = type.empty() ? "" : fmt::format(" type=\"{}\"", attribute_xml(type));
    return fmt::format("      <{}{} message=\"{}\">{}</{}>\n", name, kind, attribute_xml(message), data(content), name);
}

std::string failure(std::string_view type, std::string_view message, const std::optional<FilePlace>& where,
                    const std::string& trace) {
    std::string first(message);
    if (where) first += fmt::format(" ({}:{})", where->file, where->at.line);
    if (trace.empty()) return element("failure", type, first, first);
    return element("failure", type, first + "\n" + first_lines(trace), first + "\n" + trace);
}

std::string result(const PropertyResult& answer, const std::optional<FilePlace>& where) {
    const Verdict& verdict = answer.verdict;
    if (verdict.outcome == Outcome::Unknown) {
        const std::string message = "unknown: " + verdict.reason;
        return verdict.declared ? element("error", word(verdict.obstacle), message, "")
                                : element("skipped", "", message, "");
    }
    if (as_expected(verdict)) return {};
    const std::string message(verdict.expected_violated ? "holds, but expected to be violated" : "violated");
    return failure(word(verdict.outcome), message, where, answer.trace ? run_text(*answer.trace, end_of(verdict)) : "");
}

/// Returns the output of a test case: the text of the property and, if the property holds vacuously, a note.
std::string output(const PropertyResult& answer) {
    if (!answer.verdict.vacuous) return answer.text;
    return fmt::format("{}{}{}, vacuously: {}", answer.text, answer.text.empty() ? "" : "\n",
                       word(answer.verdict.outcome), fmt::join(answer.verdict.notes, "; "));
}

struct Case {
    std::string_view suite = {}, name = {}, text = {};
    std::optional<FilePlace> where = {};
    double seconds = 0;
};

std::string test_case(const Case& about, const std::string& result) {
    std::string xml = fmt::format("    <testcase classname=\"{}\" name=\"{}\"", attribute_xml(about.suite),
                                  attribute_xml(about.name));
    if (about.where)
        xml += fmt::format(" file=\"{}\" line=\"{}\"", attribute_xml(about.where->file), about.where->at.line);
    xml += fmt::format(" time=\"{:.3f}\"", about.seconds);
    if (result.empty() && about.text.empty()) return xml + "/>\n";
    xml += ">\n" + result;
    if (!about.text.empty()) xml += fmt::format("      <system-out>{}</system-out>\n", data(about.text));
    return xml + "    </testcase>\n";
}

std::string suite_of_error(std::string_view file, const std::string& one_case) {
    return fmt::format(
               "  <testsuite name=\"{}\" tests=\"1\" failures=\"0\" errors=\"1\" skipped=\"0\" time=\"0.000\">\n",
               attribute_xml(file)) +
           one_case + "  </testsuite>\n";
}

}  // namespace

std::string junit_suite(const Report& report, const ReportSource& written) {
    const Tally count = tally(report);
    double seconds = 0;
    std::string cases;
    for (const ModelErrorTrace& breakdown : report.error_traces) {
        const auto where = file_place(written.sources, origin(written));
        const std::string trace = breakdown.trace.steps.empty() ? "" : run_text(breakdown.trace, "");
        cases += test_case({report.model, breakdown.code, "", where, 0},
                           failure(breakdown.code, breakdown.message, where, trace));
    }
    for (const PropertyResult& answer : report.answers) {
        const Verdict& verdict = answer.verdict;
        const auto where = file_place(written.sources, origin(written, verdict));
        const std::string text = output(answer);
        cases += test_case({report.model, verdict.property, text, where, verdict.seconds}, result(answer, where));
        seconds = std::max(seconds, verdict.seconds);
    }
    return fmt::format(
               "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3f}\">\n",
               attribute_xml(report.model), report.answers.size() + report.error_traces.size(),
               count.unexpected + report.error_traces.size(), count.unknown, count.undeclared_unknown, seconds) +
           cases + "  </testsuite>\n";
}

std::string junit_suite(std::string_view file, const std::vector<Diagnostic>& diagnostics, const Sources& sources) {
    const auto first = std::ranges::find(diagnostics, Severity::Error, &Diagnostic::severity);
    if (first == diagnostics.end()) return {};
    std::ostringstream all;
    render_text(diagnostics, sources, Colour::Plain, all);
    const auto where = file_place(sources, first->where);
    const std::string message =
        where ? fmt::format("{} ({}:{})", first->message, where->file, where->at.line) : first->message;
    return suite_of_error(
        file, test_case({file, "input", "", where, 0}, element("error", first->code, message, std::move(all).str())));
}

std::string junit_suite(std::string_view file, std::string_view type, std::string_view message) {
    return suite_of_error(file, test_case({file, "run", "", {}, 0}, element("error", type, message, "")));
}

std::string junit_suite(std::string_view file, const std::vector<JunitCase>& cases, std::string_view ended) {
    std::string text;
    std::size_t failures = 0;
    for (const JunitCase& each : cases) {
        const FilePlace where{std::string(file), {each.line, 1}};
        failures += each.failure.empty() ? 0U : 1U;
        text += test_case({file, each.name, "", where, 0},
                          each.failure.empty() ? "" : failure("unmet", each.failure, where, ""));
    }
    if (!ended.empty()) text += test_case({file, "script", "", {}, 0}, element("error", "command", ended, ""));
    return fmt::format(
               "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"0\" time=\"0.000\">\n",
               attribute_xml(file), cases.size() + (ended.empty() ? 0U : 1U), failures, ended.empty() ? 0 : 1) +
           text + "  </testsuite>\n";
}

std::string junit_document(std::string_view suites) {
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n{}</testsuites>\n", suites);
}

}  // namespace grafverif
