// SPDX-License-Identifier: MIT
#include "report/sarif.hpp"

#include <algorithm>
#include <ostream>
#include <string_view>

#include "report/findings.hpp"
#include "report/report.hpp"
#include "report/table.hpp"
#include "report/terminal.hpp"
#include "support/json_text.hpp"
#include "support/text/documentation.hpp"
#include "support/text/encoding.hpp"

namespace grafverif {

namespace {

using Json = SarifLog::Json;

/// Returns a path as a URI. Characters that are not allowed are escaped byte by byte (RFC 3986).
std::string uri(std::string_view path) {
    constexpr std::string_view plain = "-._~/:";
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string text;
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (letter || plain.find(c) != std::string_view::npos) text += c;
        else text += {'%', digits[byte >> 4U], digits[byte & 15U]};
    }
    return text;
}

/// Returns the column, counted in characters, of the byte at `offset`.
std::size_t column(const Source& source, std::uint32_t offset) {
    const std::size_t bytes = place(source.text, offset).column - 1;
    const std::string_view line = line_at(source.text, offset).substr(0, bytes);
    return 1 + bytes - static_cast<std::size_t>(std::ranges::count_if(line, continues_character));
}

Json location(Span where, const Sources& sources) {
    const Source& source = sources[where.source];
    const Place begin = place(source.text, where.begin), end = place(source.text, where.end);
    return {{"physicalLocation",
             {{"artifactLocation", {{"uri", uri(source.name)}}},
              {"region",
               {{"startLine", begin.line},
                {"startColumn", column(source, where.begin)},
                {"endLine", end.line},
                {"endColumn", column(source, where.end)}}}}}};
}

Json text_json(std::string_view text) { return Json{{"text", text}}; }

/// Returns the index of the rule in the log; adds the rule if the log does not contain it.
std::size_t rule_index(SarifLog& log, std::string_view id, std::string_view meaning, std::string_view level) {
    for (std::size_t index = 0; index < log.rules.size(); ++index)
        if (log.rules[index]["id"] == id) return index;
    log.rules.push_back(
        {{"id", id}, {"shortDescription", text_json(meaning)}, {"defaultConfiguration", {{"level", level}}}});
    return log.rules.size() - 1;
}

// -- findings ---------------------------------------------------------------------------------------------------------

Json result(const Finding& finding, std::size_t rule, const Sources& sources) {
    std::string message = finding.message;
    if (finding.evidence) message += ". Inputs: " + inputs_text(*finding.evidence) + ": " + finding.evidence_shows;
    Json object = {
        {"ruleId", finding.code}, {"ruleIndex", rule}, {"level", word(finding.level)}, {"message", text_json(message)}};
    if (sources.contains(finding.origin.source)) object["locations"] = Json::array({location(finding.origin, sources)});
    for (const Finding::Related& related : finding.related) {
        if (!sources.contains(related.where.source)) continue;
        Json place = location(related.where, sources);
        place["message"] = text_json(related.message);
        object["relatedLocations"].push_back(std::move(place));
    }
    if (finding.accepted) object["suppressions"] = {{{"kind", "inSource"}, {"justification", *finding.accepted}}};
    return object;
}

// -- verdicts ---------------------------------------------------------------------------------------------------------

constexpr std::string_view violated = "property-violated", holds = "property-holds", unknown = "property-unknown",
                           vacuous = "property-vacuous";

/// Returns a row of the trace as one line: `3 s: Lamp: dark; cleared t1; situation 2; outputs none`.
std::string row_text(const ChartRun& run, std::size_t index) {
    const Cells row = cells(run, index, index == 0);
    std::string text = row[0];
    const auto add = [&text](std::string_view separator, std::string_view what) {
        text += (text.empty() ? "" : std::string(separator)) + std::string(what);
    };
    if (!row[1].empty()) add(": ", row[1]);
    for (std::size_t column = 2; column < row.size(); ++column)
        if (!row[column].empty()) add("; ", std::string(column_titles[column]) + " " + row[column]);
    if (run.loop_from == index) text = "repeated forever from here: " + text;
    return text;
}

Json code_flow(const ChartRun& run, std::string_view end, const ReportSource& written) {
    Json locations = Json::array();
    for (const std::size_t index : shown_rows(run)) {
        const Span where = origin(written, run, index);
        Json place = written.sources.contains(where.source) ? location(where, written.sources) : Json::object();
        std::string text = row_text(run, index);
        if (text.empty()) text = "nothing changes";
        place["message"] = text_json(text);
        locations.push_back({{"location", std::move(place)},
                             {"executionOrder", locations.size() + 1},
                             {"importance", run.rows[index].fired.empty() ? "important" : "essential"}});
    }
    if (!end.empty() && !run.loop_from && !locations.empty()) {
        Json& last = locations.back()["location"]["message"]["text"];
        last = last.get<std::string>() + "; " + std::string(end);
    }
    return {{"threadFlows", {{{"locations", std::move(locations)}}}}};
}

/// Returns a SARIF result. `kind` is `fail`, `open` (undecided property) or `review` (property that holds vacuously). A
/// result of kind `fail` has the level `error`; all other results have the level `none`.
Json result(std::string_view rule, std::size_t index, std::string_view kind, std::string_view message, Span where,
            const ReportSource& written) {
    Json object = {{"ruleId", rule},
                   {"ruleIndex", index},
                   {"kind", kind},
                   {"level", kind == "fail" ? "error" : "none"},
                   {"message", text_json(message)}};
    if (written.sources.contains(where.source)) object["locations"] = Json::array({location(where, written.sources)});
    return object;
}

std::string_view meaning(std::string_view rule) {
    if (rule == violated) return "a property is violated";
    if (rule == vacuous) return "a property holds vacuously";
    if (rule == holds) return "a property holds but is expected to be violated";
    return "the verdict on a property is unknown";
}

void add_result(const Report& report, const PropertyResult& answer, const ReportSource& written, SarifLog& log) {
    const Verdict& verdict = answer.verdict;
    std::string message = report.model + ": " + verdict.property;
    if (!answer.text.empty()) message += " \"" + answer.text + '"';
    message += ": " + std::string(word(verdict.outcome));
    if (verdict.vacuous) {
        std::string why = message + ", vacuously";
        for (const std::string& note : verdict.notes) why += "; " + note;
        const std::size_t index = rule_index(log, vacuous, meaning(vacuous), "note");
        log.results.push_back(result(vacuous, index, "review", why, origin(written, verdict), written));
    }
    if (as_expected(verdict)) return;
    const bool open = verdict.outcome == Outcome::Unknown;
    const std::string_view rule = open ? unknown : verdict.outcome == Outcome::Holds ? holds : violated;
    if (open) message += ": " + verdict.reason;
    else if (verdict.outcome == Outcome::Holds) message += ", but expected to be violated";
    const std::size_t index = rule_index(log, rule, meaning(rule), open ? "warning" : "error");
    Json object = result(rule, index, open ? "open" : "fail", message, origin(written, verdict), written);
    if (answer.trace && !answer.trace->rows.empty())
        object["codeFlows"] = Json::array({code_flow(*answer.trace, end_of(verdict), written)});
    log.results.push_back(std::move(object));
    if (!open) return;
    // An unknown verdict makes the run unsuccessful only if the property is declared; the exit code uses the same rule.
    log.successful = log.successful && !verdict.declared;
    log.notifications.push_back(
        {{"level", "warning"}, {"message", text_json("unknown: " + message)}, {"associatedRule", {{"id", rule}}}});
}

std::string_view level(Severity severity) {
    switch (severity) {
    case Severity::Error: return "error";
    case Severity::Warning: return "warning";
    case Severity::Note: return "note";
    }
    return "none";
}

}  // namespace

void add_findings(const Analysis& analysis, const Sources& sources, SarifLog& log) {
    for (const FindingKind& kind : finding_kinds()) rule_index(log, kind.code, kind.meaning, word(kind.level));
    for (const Finding& finding : analysis.findings)
        log.results.push_back(result(finding, rule_index(log, finding.code, "", "warning"), sources));
    log.successful = log.successful && analysis.open.empty() && analysis.failures.empty();
    for (const OpenQuestion& question : analysis.open) {
        const std::string subject = question.subject.empty() ? "" : " of `" + question.subject + "`";
        const std::string text =
            "inconclusive (" + analysis.obstacle + "): " + question.code + subject + ": " + open_text(question);
        log.notifications.push_back(
            {{"level", "warning"}, {"message", text_json(text)}, {"associatedRule", {{"id", question.code}}}});
    }
}

void add_report(const Report& report, const ReportSource& written, SarifLog& log) {
    for (const ModelErrorTrace& breakdown : report.error_traces) {
        const std::size_t index = rule_index(log, breakdown.code, "model error", "error");
        Json object = result(breakdown.code, index, "fail", report.model + ": model error: " + breakdown.message,
                             origin(written), written);
        if (!breakdown.trace.rows.empty()) object["codeFlows"] = Json::array({code_flow(breakdown.trace, "", written)});
        log.results.push_back(std::move(object));
    }
    for (const PropertyResult& answer : report.answers) add_result(report, answer, written, log);
    log.successful = log.successful && report.failures.empty();
}

void add_diagnostics(const std::vector<Diagnostic>& diagnostics, const Sources& sources, bool warnings, SarifLog& log) {
    for (const Diagnostic& diagnostic : diagnostics) {
        const bool error = diagnostic.severity == Severity::Error;
        if (!error && !warnings) continue;
        const std::string meaning = error ? "an error in the input" : "a warning about the input";
        const std::size_t rule = rule_index(log, diagnostic.code, meaning, level(diagnostic.severity));
        if (std::string page = diagnostic_page(diagnostic.code); !page.empty())
            log.rules[rule]["helpUri"] = std::move(page);
        Json object = {{"ruleId", diagnostic.code},
                       {"ruleIndex", rule},
                       {"level", level(diagnostic.severity)},
                       {"message", text_json(diagnostic.message)}};
        if (sources.contains(diagnostic.where.source))
            object["locations"] = Json::array({location(diagnostic.where, sources)});
        for (const Diagnostic& note : diagnostic.notes) {
            if (!sources.contains(note.where.source)) continue;
            Json place = location(note.where, sources);
            place["message"] = text_json(note.message);
            object["relatedLocations"].push_back(std::move(place));
        }
        log.results.push_back(std::move(object));
        log.successful = log.successful && !error;
    }
}

void print_sarif(const SarifLog& log, const std::string& version, std::ostream& out) {
    Json invocation = {{"executionSuccessful", log.successful}};
    if (!log.notifications.empty()) invocation["toolExecutionNotifications"] = log.notifications;
    const Json document = {
        {"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
        {"version", "2.1.0"},
        {"runs",
         {{{"tool", {{"driver", {{"name", "grafverif"}, {"version", version}, {"rules", log.rules}}}}},
           {"invocations", Json::array({std::move(invocation)})},
           {"columnKind", "unicodeCodePoints"},
           {"results", log.results}}}}};
    out << json_text(document) << '\n';
}

}  // namespace grafverif
