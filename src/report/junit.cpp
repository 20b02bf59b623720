// SPDX-License-Identifier: MIT
#include "report/junit.hpp"

#include <fmt/format.h>

#include <ostream>
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

std::string told(const ChartRun& run) {
    std::ostringstream text;
    print_trace(run, text);
    return data(text.str());
}

/// `<failure ...>`, `<error ...>` or `<skipped ...>`.
std::string element(std::string_view name, std::string_view type, std::string_view message,
                    const std::string& content) {
    const std::string kind = type.empty() ? "" : fmt::format(" type=\"{}\"", attribute_xml(type));
    return fmt::format("      <{}{} message=\"{}\">{}</{}>\n", name, kind, attribute_xml(message), content, name);
}

std::string result(const Answer& answer) {
    const Verdict& verdict = answer.verdict;
    if (verdict.outcome == Outcome::Unknown) {
        const std::string message = "unknown: " + verdict.reason;
        return verdict.declared ? element("error", word(verdict.obstacle), message, "")
                                : element("skipped", "", message, "");
    }
    if (as_expected(verdict)) return {};
    const std::string message(verdict.expected_violated ? "holds, but expected to be violated" : "violated");
    return element("failure", word(verdict.outcome), message, answer.trace ? told(*answer.trace) : "");
}

std::string test_case(const Report& report, std::string_view name, std::string_view text, double seconds,
                      const std::string& result) {
    std::string xml = fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"",
                                  attribute_xml(report.model), attribute_xml(name), seconds);
    if (result.empty() && text.empty()) return xml + "/>\n";
    xml += ">\n" + result;
    if (!text.empty()) xml += fmt::format("      <system-out>{}</system-out>\n", data(text));
    return xml + "    </testcase>\n";
}

}  // namespace

void print_junit(const Report& report, std::ostream& out) {
    const Tally count = tally(report);
    double seconds = 0;
    std::string cases;
    for (const Breakdown& breakdown : report.breakdowns)
        cases += test_case(report, breakdown.code, "", 0,
                           element("failure", breakdown.code, breakdown.message,
                                   breakdown.trace.steps.empty() ? "" : told(breakdown.trace)));
    for (const Answer& answer : report.answers) {
        cases += test_case(report, answer.verdict.property, answer.text, answer.verdict.seconds, result(answer));
        seconds = std::max(seconds, answer.verdict.seconds);
    }
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    out << fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3f}\">\n",
        attribute_xml(report.model), report.answers.size() + report.breakdowns.size(),
        count.unexpected + report.breakdowns.size(), count.unknown, count.undeclared_unknown, seconds);
    out << cases << "  </testsuite>\n</testsuites>\n";
}

}  // namespace grafverif
