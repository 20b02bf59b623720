// SPDX-License-Identifier: MIT
#include "report/json.hpp"

#include <charconv>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

#include "report/json_place.hpp"
#include "report/json_trace.hpp"
#include "report/profile.hpp"
#include "report/settings_text.hpp"
#include "report/terminal.hpp"
#include "report/why.hpp"
#include "support/json_text.hpp"
#include "syntax/print/constants.hpp"

namespace grafverif {

namespace {

using Json = nlohmann::ordered_json;

/// Returns a JSON number if the value fits into 64 bits. Otherwise returns a string with its digits, because many JSON
/// parsers do not support larger numbers.
Json number(const std::string& decimal) {
    if (decimal.empty()) return nullptr;
    std::uint64_t value = 0;
    const char* const end = decimal.data() + decimal.size();
    const std::from_chars_result read = std::from_chars(decimal.data(), end, value);
    return read.ec == std::errc() && read.ptr == end ? Json(value) : Json(decimal);
}

/// Adds the constants of the closed loop with their current values. Adds nothing if the loop has no constants.
void add_constants(Json& object, const CheckSettings& settings) {
    if (settings.constants.empty()) return;
    Json list = Json::array();
    for (const NamedConstant& each : settings.constants) {
        Json value = value_text(each);
        if (each.kind == NamedConstant::Kind::Boolean) value = each.value != 0;
        if (each.kind == NamedConstant::Kind::Integer) value = each.value;
        list.push_back({{"name", each.name}, {"value", std::move(value)}, {"set", each.set}});
    }
    object["constants"] = std::move(list);
}

/// Returns the lines of the printed trace of a run.
Json trace_text(const ChartRun& run, std::string_view end) {
    std::ostringstream text;
    print_trace(run, text);
    if (!run.loop_from && !end.empty()) text << "    " << end << '\n';
    Json lines = Json::array();
    std::istringstream read(std::move(text).str());
    for (std::string line; std::getline(read, line);) lines.push_back(line);
    return lines;
}

Json property(const Report& report, const PropertyResult& answer, const Sources& sources) {
    const Verdict& verdict = answer.verdict;
    Json made = {{"name", verdict.property}, {"text", text_or_null(answer.text)}};
    add_place(made, file_place(sources, verdict.origin));
    const Json found = {{"verdict", word(verdict.outcome)},
                        {"expected", verdict.expected_violated ? "violated" : "holds"},
                        {"declared", verdict.declared},
                        {"engine", text_or_null(report.settings.engine)},
                        {"mode", text_or_null(report.settings.mode)},
                        {"grain", text_or_null(report.settings.grain)},
                        {"states", number(verdict.states)},
                        {"transitions", verdict.transitions ? Json(*verdict.transitions) : Json(nullptr)},
                        {"seconds", verdict.seconds},
                        {"reason", text_or_null(verdict.reason)},
                        {"vacuous", verdict.vacuous},
                        {"notes", verdict.notes},
                        {"assumptions", settings_text(report, answer)},
                        {"trace_text", answer.trace ? trace_text(*answer.trace, end_of(verdict)) : Json(nullptr)},
                        {"trace", answer.trace ? trace_json(*answer.trace) : Json(nullptr)}};
    made.update(found);
    if (!report.settings.cycle.empty()) made["cycle"] = report.settings.cycle;
    const SearchScope& scope = verdict.scope;
    if (!scope.searched.empty() || !scope.left_out.empty())
        made[scope.cells ? "cells" : "sub_loops"] = {
            {"searched", scope.searched}, {"left_out", scope.left_out}, {"because", text_or_null(scope.because)}};
    if (verdict.abstraction)
        made["abstraction"] = {{"chosen", verdict.abstraction->chosen},
                               {"untimed", verdict.abstraction->untimed},
                               {"paced", verdict.abstraction->paced},
                               {"shortest", answer.trace ? Json(false) : Json(nullptr)}};
    return made;
}

/// Returns an array with one object for each trial of a remedy. In a trial, `check` repeats the check with other
/// options.
Json trials_json(const std::vector<Trial>& trials) {
    Json list = Json::array();
    for (const Trial& trial : trials) {
        Json decided = Json::array();
        for (const PropertyResult& answer : trial.decided)
            decided.push_back({{"name", answer.verdict.property},
                               {"verdict", word(answer.verdict.outcome)},
                               {"vacuous", answer.verdict.vacuous},
                               {"states", number(answer.verdict.states)},
                               {"preservation", text_or_null(answer.preservation)}});
        list.push_back({{"options", trial.options}, {"decided", std::move(decided)}, {"seconds", trial.seconds}});
    }
    return list;
}

Json certificate_json(const CertificateSummary& certificate) {
    Json certified = Json::array(), omitted = Json::array();
    for (const CertificateSummary::Certified& one : certificate.certified) certified.push_back(one.property);
    for (const CertificateSummary::Omitted& one : certificate.omitted)
        omitted.push_back({{"property", one.property}, {"reason", one.reason}});
    return {{"folder", certificate.folder}, {"certified", std::move(certified)}, {"omitted", std::move(omitted)}};
}

}  // namespace

void print_json(const Report& report, const Sources& sources, std::ostream& out, const ProofExplanation* why,
                const std::vector<Trial>& trials, const CertificateSummary* certificate) {
    Json properties = Json::array();
    for (const PropertyResult& answer : report.answers) properties.push_back(property(report, answer, sources));
    Json document = {{"model", report.model}};
    add_constants(document, report.settings);
    document["properties"] = std::move(properties);
    if (!report.error_traces.empty()) {
        Json errors = Json::array();
        for (const ModelErrorTrace& breakdown : report.error_traces)
            errors.push_back({{"code", breakdown.code},
                              {"message", breakdown.message},
                              {"trace_text", trace_text(breakdown.trace, "")},
                              {"trace", trace_json(breakdown.trace)}});
        document["errors"] = std::move(errors);
    }
    if (!trials.empty()) document["remedies"] = trials_json(trials);
    if (report.profile) document["profile"] = profile_json(*report.profile);
    if (certificate != nullptr) document["certificate"] = certificate_json(*certificate);
    if (why != nullptr) document["why"] = why_json(*why);
    out << json_text(document) << '\n';
}

namespace {

void print_line(const Json& object, std::ostream& out) { out << json_text(object, -1) << '\n'; }

Json error_line(const std::optional<FilePlace>& where, const Json& model, std::string_view code,
                std::string_view message) {
    Json line = Json::object();
    add_place(line, where);
    line.update({{"model", model}, {"property", nullptr}, {"verdict", "error"}, {"code", code}, {"message", message}});
    return line;
}

}  // namespace

void print_json_lines(const Report& report, const ReportSource& written, std::ostream& out) {
    for (const ModelErrorTrace& breakdown : report.error_traces) {
        Json line =
            error_line(file_place(written.sources, origin(written)), report.model, breakdown.code, breakdown.message);
        line["trace_text"] = trace_text(breakdown.trace, "");
        print_line(line, out);
    }
    for (const PropertyResult& answer : report.answers) {
        const Verdict& verdict = answer.verdict;
        const bool shown = answer.trace && !as_expected(verdict);
        Json line = Json::object();
        add_place(line, file_place(written.sources, origin(written, verdict)));
        const Json found = {{"model", report.model},
                            {"property", verdict.property},
                            {"text", text_or_null(answer.text)},
                            {"verdict", word(verdict.outcome)},
                            {"expected", verdict.expected_violated ? "violated" : "holds"},
                            {"declared", verdict.declared},
                            {"as_expected", as_expected(verdict)},
                            {"engine", text_or_null(report.settings.engine)},
                            {"mode", text_or_null(report.settings.mode)},
                            {"grain", text_or_null(report.settings.grain)},
                            {"states", number(verdict.states)},
                            {"seconds", verdict.seconds},
                            {"reason", text_or_null(verdict.reason)},
                            {"vacuous", verdict.vacuous},
                            {"notes", verdict.notes},
                            {"trace_text", shown ? trace_text(*answer.trace, end_of(verdict)) : Json(nullptr)}};
        line.update(found);
        if (!report.settings.cycle.empty()) line["cycle"] = report.settings.cycle;
        add_constants(line, report.settings);
        print_line(line, out);
    }
}

void print_json_lines(const std::string& file, const std::vector<Diagnostic>& diagnostics, const Sources& sources,
                      std::ostream& out) {
    for (const Diagnostic& diagnostic : diagnostics) {
        if (diagnostic.severity != Severity::Error) continue;
        auto where = file_place(sources, diagnostic.where);
        Json line = error_line(where, nullptr, diagnostic.code, diagnostic.message);
        if (!where) line["file"] = file;
        print_line(line, out);
    }
}

}  // namespace grafverif
