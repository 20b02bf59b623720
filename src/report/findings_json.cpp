// SPDX-License-Identifier: MIT
// Findings for programs: JSON of our own, and SARIF.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "report/findings.hpp"
#include "report/json_trace.hpp"
#include "support/json_text.hpp"

namespace grafverif {

namespace {

using FindingJson = nlohmann::ordered_json;

void add_place(FindingJson& object, Span where, const Sources& sources) {
    for (const char* key : {"file", "line", "column"}) object[key] = nullptr;
    if (!sources.contains(where.source)) return;
    const Source& source = sources[where.source];
    const Place at = place(source.text, where.begin);
    object["file"] = source.name;
    object["line"] = at.line;
    object["column"] = at.column;
}

FindingJson open_json(const OpenQuestion& question) {
    return {{"code", question.code},
            {"subject", text_or_null(question.subject)},
            {"instants", question.instants},
            {"evolutions", question.evolutions == 0 ? FindingJson(nullptr) : FindingJson(question.evolutions)}};
}

FindingJson timing(const Finding& finding) {
    switch (finding.timing) {
    case Finding::Timing::Untimed: return nullptr;
    case Finding::Timing::Confirmed: return "confirmed";
    case Finding::Timing::Unconfirmed: return "unconfirmed";
    }
    return nullptr;
}

FindingJson as_json(const Finding& finding, const Sources& sources) {
    FindingJson object = {{"code", finding.code},
                          {"level", word(finding.level)},
                          {"subject", text_or_null(finding.subject)},
                          {"message", finding.message}};
    add_place(object, finding.origin, sources);
    object["related"] = FindingJson::array();
    for (const Finding::Related& related : finding.related) {
        FindingJson place = {{"message", related.message}};
        add_place(place, related.where, sources);
        object["related"].push_back(std::move(place));
    }
    object["timing"] = timing(finding);
    object["accepted"] = finding.accepted ? FindingJson(*finding.accepted) : FindingJson(nullptr);
    object["shows"] = text_or_null(finding.evidence_shows);
    object["trace"] = finding.evidence ? trace_json(*finding.evidence) : FindingJson(nullptr);
    return object;
}

// -- SARIF -------------------------------------------------------------------------------------------------------------

/// A path as a URI: what a URI does not take is escaped byte by byte (RFC 3986).
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

/// The column of byte `offset`, in characters.
std::size_t column(const Source& source, std::uint32_t offset) {
    const std::size_t bytes = place(source.text, offset).column - 1;
    const std::string_view line = line_at(source.text, offset).substr(0, bytes);
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
    return 1 + bytes - static_cast<std::size_t>(std::ranges::count_if(line, continues));
}

FindingJson location(Span where, const Sources& sources) {
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

FindingJson rules() {
    FindingJson list = FindingJson::array();
    for (const FindingKind& kind : finding_kinds())
        list.push_back({{"id", kind.code},
                        {"shortDescription", {{"text", kind.meaning}}},
                        {"defaultConfiguration", {{"level", word(kind.level)}}}});
    return list;
}

std::size_t rule_index(const std::string& code) {
    std::size_t index = 0;
    while (index < finding_kinds().size() && finding_kinds()[index].code != code) ++index;
    return index;
}

FindingJson result(const Finding& finding, const Sources& sources) {
    std::string message = finding.message;
    if (finding.evidence) message += ". Inputs: " + inputs_text(*finding.evidence) + ": " + finding.evidence_shows;
    FindingJson object = {{"ruleId", finding.code},
                          {"ruleIndex", rule_index(finding.code)},
                          {"level", word(finding.level)},
                          {"message", {{"text", message}}}};
    if (sources.contains(finding.origin.source)) object["locations"] = {location(finding.origin, sources)};
    for (const Finding::Related& related : finding.related) {
        if (!sources.contains(related.where.source)) continue;
        FindingJson place = location(related.where, sources);
        place["message"] = {{"text", related.message}};
        object["relatedLocations"].push_back(std::move(place));
    }
    if (finding.accepted) object["suppressions"] = {{{"kind", "inSource"}, {"justification", *finding.accepted}}};
    return object;
}

void dump(const FindingJson& object, std::ostream& out) { out << json_text(object) << '\n'; }

}  // namespace

void print_findings_json(const Analysis& analysis, const Sources& sources, std::ostream& out) {
    FindingJson object = {
        {"chart", analysis.chart},
        {"mode", analysis.mode == ExecutionMode::StabilitySearch ? "stability-search" : "every-cycle"},
        {"complete", analysis.open.empty()},
        {"obstacle", text_or_null(analysis.obstacle)},
        {"instants", analysis.instants},
        {"seconds", analysis.seconds},
        {"questions", analysis.questions},
        {"open", FindingJson::array()},
        {"notes", analysis.notes},
        {"findings", FindingJson::array()}};
    for (const OpenQuestion& question : analysis.open) object["open"].push_back(open_json(question));
    for (const Finding& finding : analysis.findings) object["findings"].push_back(as_json(finding, sources));
    dump(object, out);
}

void print_findings_sarif(const Analysis& analysis, const Sources& sources, const std::string& version,
                          std::ostream& out) {
    FindingJson results = FindingJson::array();
    for (const Finding& finding : analysis.findings) results.push_back(result(finding, sources));
    FindingJson invocation = {{"executionSuccessful", analysis.open.empty() && analysis.failures.empty()}};
    for (const OpenQuestion& question : analysis.open) {
        const std::string subject = question.subject.empty() ? "" : " of `" + question.subject + "`";
        const std::string text =
            "not decided (" + analysis.obstacle + "): " + question.code + subject + ": " + open_text(question);
        invocation["toolExecutionNotifications"].push_back(
            {{"level", "warning"}, {"message", {{"text", text}}}, {"associatedRule", {{"id", question.code}}}});
    }
    dump({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
          {"version", "2.1.0"},
          {"runs",
           {{{"tool", {{"driver", {{"name", "grafverif"}, {"version", version}, {"rules", rules()}}}}},
             {"invocations", {std::move(invocation)}},
             {"columnKind", "unicodeCodePoints"},
             {"results", std::move(results)}}}}},
         out);
}

}  // namespace grafverif
