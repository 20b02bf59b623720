// SPDX-License-Identifier: MIT
// Writes findings as JSON; for SARIF see report/sarif.cpp.
#include <nlohmann/json.hpp>
#include <ostream>

#include "report/findings.hpp"
#include "report/json_place.hpp"
#include "report/json_trace.hpp"
#include "support/json_text.hpp"

namespace grafverif {

namespace {

using FindingJson = nlohmann::ordered_json;

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
    add_place(object, file_place(sources, finding.origin));
    object["related"] = FindingJson::array();
    for (const Finding::Related& related : finding.related) {
        FindingJson place = {{"message", related.message}};
        add_place(place, file_place(sources, related.where));
        object["related"].push_back(std::move(place));
    }
    if (!finding.lost.empty()) object["never_again"] = finding.lost;
    object["timing"] = timing(finding);
    object["accepted"] = finding.accepted ? FindingJson(*finding.accepted) : FindingJson(nullptr);
    object["shows"] = text_or_null(finding.evidence_shows);
    object["trace"] = finding.evidence ? trace_json(*finding.evidence) : FindingJson(nullptr);
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

}  // namespace grafverif
