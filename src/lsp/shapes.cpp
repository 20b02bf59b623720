// SPDX-License-Identifier: MIT
#include "lsp/shapes.hpp"

#include <nlohmann/json.hpp>

#include "support/overloaded.hpp"

namespace grafverif::lsp {

namespace {

int number_of(Severity severity) {
    switch (severity) {
    case Severity::Error: return 1;
    case Severity::Warning: return 2;
    case Severity::Note: return 3;
    }
    unreachable();
}

std::uint32_t small_number(const Json& json) {
    const auto number = json.get<std::int64_t>();
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(number, 0, UINT32_MAX - 1));
}

std::string title_of(const Edit& edit) {
    const std::size_t from = edit.replacement.find_first_not_of(" \n");
    const std::size_t to = edit.replacement.find_last_not_of(" \n");
    return from == std::string::npos ? "remove it" : "write `" + edit.replacement.substr(from, to + 1 - from) + "`";
}

}  // namespace

Json json_of(Position position) { return {{"line", position.line}, {"character", position.character}}; }

Json json_of(Range range) { return {{"start", json_of(range.start)}, {"end", json_of(range.end)}}; }

Json json_of(const Place& place, const UriOf& uri_of) {
    return {{"uri", uri_of(place.path)}, {"range", json_of(place.range)}};
}

Json json_of(const LspDiagnostic& diagnostic, const UriOf& uri_of) {
    Json json = {{"range", json_of(diagnostic.where.range)},
                 {"severity", number_of(diagnostic.severity)},
                 {"source", "grafverif"},
                 {"message", diagnostic.message}};
    if (!diagnostic.code.empty()) json["code"] = diagnostic.code;
    if (!diagnostic.page.empty()) json["codeDescription"] = {{"href", diagnostic.page}};
    for (const Related& related : diagnostic.related)
        json["relatedInformation"].push_back(
            {{"location", json_of(related.where, uri_of)}, {"message", related.message}});
    return json;
}

Json json_of(const std::vector<Edit>& edits, const UriOf& uri_of) {
    Json changes = Json::object();
    for (const Edit& edit : edits)
        changes[uri_of(edit.where.path)].push_back(
            {{"range", json_of(edit.where.range)}, {"newText", edit.replacement}});
    return {{"changes", std::move(changes)}};
}

Json quick_fix(const LspDiagnostic& diagnostic, const UriOf& uri_of) {
    return {{"title", title_of(*diagnostic.fix)},
            {"kind", "quickfix"},
            {"isPreferred", true},
            {"diagnostics", Json::array({json_of(diagnostic, uri_of)})},
            {"edit", json_of(std::vector{*diagnostic.fix}, uri_of)}};
}

Position position_of(const Json& json) { return {small_number(json.at("line")), small_number(json.at("character"))}; }

Range range_of(const Json& json) { return {position_of(json.at("start")), position_of(json.at("end"))}; }

std::vector<Change> changes_of(const Json& json) {
    std::vector<Change> changes;
    for (const Json& each : json) {
        Change change{{}, each.at("text").get<std::string>()};
        if (each.contains("range") && !each["range"].is_null()) change.range = range_of(each["range"]);
        changes.push_back(std::move(change));
    }
    return changes;
}

bool flag(const Json& object, std::initializer_list<const char*> path) {
    const Json* here = &object;
    for (const char* name : path) {
        const auto found = here->is_object() ? here->find(name) : here->end();
        if (!here->is_object() || found == here->end()) return false;
        here = &*found;
    }
    return here->is_boolean() && here->get<bool>();
}

}  // namespace grafverif::lsp
