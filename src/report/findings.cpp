// SPDX-License-Identifier: MIT
// Writes findings as text.
#include "report/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <set>
#include <string_view>
#include <utility>

#include "report/table.hpp"
#include "report/terminal.hpp"
#include "support/printable.hpp"

namespace grafverif {

namespace {

Diagnostic diagnostic(const Finding& finding) {
    Diagnostic made;
    switch (finding.level) {
    case Finding::Level::Error: made.severity = Severity::Error; break;
    case Finding::Level::Warning: made.severity = Severity::Warning; break;
    case Finding::Level::Note: made.severity = Severity::Note; break;
    }
    made.code = finding.code;
    made.where = finding.origin;
    made.message = finding.message;
    for (const Finding::Related& related : finding.related)
        made.notes.push_back({Severity::Note, "", related.where, related.message, {}});
    return made;
}

void print_evidence(const Finding& finding, std::ostream& out) {
    if (finding.timing == Finding::Timing::Unconfirmed)
        out << "    depends on the order of timer expiries; no times were found that produce this order\n";
    if (!finding.evidence) return;
    out << "    shortest trace: " << printable(finding.evidence_shows) << '\n';
    print_trace(*finding.evidence, out);
}

void print_accepted(const Analysis& analysis, std::ostream& out) {
    for (const Finding& finding : analysis.findings)
        if (finding.accepted)
            out << fmt::format("accepted: {} [{}]: {}\n", printable(finding.message), finding.code,
                               printable(*finding.accepted));
}

/// Returns a list of names such as `X4`, `X5`. After the eighth name, the list only states the number of further names.
std::string subjects_text(const std::vector<std::string>& subjects) {
    constexpr std::size_t most = 8;
    std::string text;
    for (std::size_t k = 0; k < std::min(most, subjects.size()); ++k)
        text += fmt::format("{}`{}`", k == 0 ? "" : ", ", printable(subjects[k]));
    return subjects.size() > most ? fmt::format("{} and {} more", text, subjects.size() - most) : text;
}

/// Prints the undecided checks. Undecided checks with the same code and the same extent of the search share one line.
void print_open(const Analysis& analysis, std::ostream& out) {
    if (analysis.open.empty()) return;
    out << fmt::format("inconclusive: {} of {} checks; {}\n", analysis.open.size(), analysis.questions,
                       analysis.obstacle);
    std::map<std::pair<std::string, std::string>, std::vector<std::string>> lines;
    std::set<std::pair<const void*, std::string_view>> reported;  // several undecided checks may have the same subject
    for (const OpenQuestion& question : analysis.open) {
        std::vector<std::string>& subjects = lines[{question.code, open_text(question)}];
        if (!question.subject.empty() && reported.emplace(&subjects, question.subject).second)
            subjects.push_back(question.subject);
    }
    for (const auto& [line, subjects] : lines)
        out << "    " << line.first << (subjects.empty() ? "" : " of " + subjects_text(subjects)) << ": " << line.second
            << '\n';
}

void print_tally(const Analysis& analysis, std::ostream& out) {
    std::string line;
    const auto add = [&line](std::ptrdiff_t count, std::string_view one, std::string_view many) {
        if (count != 0) line += fmt::format("{}{} {}", line.empty() ? "" : ", ", count, count == 1 ? one : many);
    };
    const auto count = [&](Finding::Level level) {
        return std::ranges::count_if(
            analysis.findings, [level](const Finding& finding) { return finding.level == level && !finding.accepted; });
    };
    add(count(Finding::Level::Error), "error", "errors");
    add(count(Finding::Level::Warning), "warning", "warnings");
    add(count(Finding::Level::Note), "note", "notes");
    add(std::ranges::count_if(analysis.findings, [](const Finding& finding) { return finding.accepted.has_value(); }),
        "accepted", "accepted");
    out << analysis.chart << ": " << (line.empty() ? "no findings" : line) << '\n';
}

}  // namespace

void print_findings(const Analysis& analysis, const Sources& sources, Colour colour, std::ostream& out) {
    for (const Finding& finding : analysis.findings) {
        if (finding.accepted) continue;
        render_text({diagnostic(finding)}, sources, colour, out);
        print_evidence(finding, out);
        out << '\n';
    }
    print_accepted(analysis, out);
    print_open(analysis, out);
    for (const std::string& note : analysis.notes) out << "note: " << printable(note) << '\n';
    print_tally(analysis, out);
}

std::string open_text(const OpenQuestion& question) {
    if (is_trap(question.code)) return "can be decided only when all situations are explored";
    const bool never =
        question.code.find("-never-") != std::string::npos || question.code.find("-always-") != std::string::npos;
    const std::string least =
        question.evolutions == 0 ? "" : fmt::format("not found in {} evolutions", question.evolutions);
    if (question.instants == 0) return least.empty() ? "not explored" : least;
    const std::string first =
        question.instants == 1 ? "the first instant" : fmt::format("the first {} instants", question.instants);
    return (never ? "true in " : "not found in ") + first + (least.empty() ? "" : ", " + least);
}

std::string inputs_text(const ChartRun& run) {
    std::string text;
    for (std::size_t k = 0; k < run.rows.size(); ++k) {
        const std::string changed = cells(run, k, false)[2];
        if (changed.empty()) continue;
        const std::string moment = seconds_text(run.after(run.rows[k]).time_ms);
        text += fmt::format("{}{} at {}", text.empty() ? "" : "; ", changed, moment);
    }
    return text;
}

}  // namespace grafverif
