// SPDX-License-Identifier: MIT
#include "report/json.hpp"

#include <charconv>
#include <nlohmann/json.hpp>
#include <ostream>

#include "report/json_trace.hpp"
#include "report/profile.hpp"
#include "support/json_text.hpp"

namespace grafverif {

namespace {

using Json = nlohmann::ordered_json;

/// A number where it fits 64 bits, else its digits: JSON has no bound, its readers do.
Json number(const std::string& decimal) {
    if (decimal.empty()) return nullptr;
    std::uint64_t value = 0;
    const char* const end = decimal.data() + decimal.size();
    const std::from_chars_result read = std::from_chars(decimal.data(), end, value);
    return read.ec == std::errc() && read.ptr == end ? Json(value) : Json(decimal);
}

Json property(const Report& report, const Answer& answer) {
    const Verdict& verdict = answer.verdict;
    Json made = {{"name", verdict.property},
                 {"text", text_or_null(answer.text)},
                 {"verdict", word(verdict.outcome)},
                 {"expected", verdict.expected_violated ? "violated" : "holds"},
                 {"engine", text_or_null(report.basis.engine)},
                 {"mode", text_or_null(report.basis.mode)},
                 {"grain", text_or_null(report.basis.grain)},
                 {"states", number(verdict.states)},
                 {"transitions", verdict.transitions ? Json(*verdict.transitions) : Json(nullptr)},
                 {"seconds", verdict.seconds},
                 {"reason", text_or_null(verdict.reason)},
                 {"vacuous", verdict.vacuous},
                 {"notes", verdict.notes},
                 {"trace", answer.trace ? trace_json(*answer.trace) : Json(nullptr)}};
    const Scope& scope = verdict.scope;
    if (!scope.searched.empty())
        made[scope.cells ? "cells" : "sub_loops"] = {
            {"searched", scope.searched}, {"left_out", scope.left_out}, {"because", text_or_null(scope.because)}};
    return made;
}

}  // namespace

void print_json(const Report& report, std::ostream& out) {
    Json properties = Json::array();
    for (const Answer& answer : report.answers) properties.push_back(property(report, answer));
    Json document = {{"model", report.model}, {"properties", std::move(properties)}};
    if (!report.breakdowns.empty()) {
        Json errors = Json::array();
        for (const Breakdown& breakdown : report.breakdowns)
            errors.push_back(
                {{"code", breakdown.code}, {"message", breakdown.message}, {"trace", trace_json(breakdown.trace)}});
        document["errors"] = std::move(errors);
    }
    if (report.profile) document["profile"] = profile_json(*report.profile);
    out << json_text(document) << '\n';
}

}  // namespace grafverif
