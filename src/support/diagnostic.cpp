// SPDX-License-Identifier: MIT
#include "grafverif/support/diagnostic.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string_view>
#include <tuple>

#include "support/json_text.hpp"
#include "support/overloaded.hpp"
#include "support/printable.hpp"

namespace grafverif {

void Diagnostics::add(Diagnostic diagnostic) {
    if (diagnostic.severity == Severity::Error) ++errors_;
    if (stored_.size() < 2 * limit && errors_ <= limit) stored_.push_back(std::move(diagnostic));
}

namespace {

std::string_view word(Severity severity) {
    switch (severity) {
    case Severity::Error: return "error";
    case Severity::Warning: return "warning";
    case Severity::Note: return "note";
    }
    unreachable();
}

std::string_view ansi(Severity severity) {
    switch (severity) {
    case Severity::Error: return "\x1b[1;31m";
    case Severity::Warning: return "\x1b[1;35m";
    case Severity::Note: return "\x1b[1;36m";
    }
    unreachable();
}

constexpr std::size_t clip_columns = 100;

/// A source line as shown: at most `clip_columns` bytes around the marked part, cut at character boundaries.
struct Excerpt {
    std::string text = {};
    std::string marks = {};  ///< blanks, tabs kept, then carets
};

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// Carets stand under the columns that the marked characters take on a terminal; there is one at least.
Excerpt excerpt(std::string_view line, std::size_t column, std::size_t length) {
    std::size_t from = column > clip_columns * 3 / 4 ? column - clip_columns / 2 : 0;
    while (from > 0 && from < line.size() && continues_character(line[from])) --from;
    std::size_t to = std::min(line.size(), from + clip_columns);
    while (to < line.size() && continues_character(line[to])) ++to;

    Excerpt shown;
    if (from > 0) shown.text = "...";
    shown.marks.assign(shown.text.size(), ' ');
    std::size_t carets = 0;
    for (std::size_t at = from; at < to;) {
        const Glyph glyph = first_glyph(line.substr(at, to - at));
        shown.text += printable(line.substr(at, glyph.bytes));
        if (at < column) shown.marks.append(line[at] == '\t' ? 1 : glyph.columns, line[at] == '\t' ? '\t' : ' ');
        else if (at < column + length) carets += glyph.columns;
        at += glyph.bytes;
    }
    if (to < line.size()) shown.text += "...";
    shown.marks.append(std::max<std::size_t>(carets, 1), '^');
    return shown;
}

void render_one(const Diagnostic& diagnostic, const Sources& sources, Colour colour, std::ostream& out) {
    const bool ansi_colours = colour == Colour::Ansi;
    const bool placed = sources.contains(diagnostic.where.source);
    if (placed) {
        const Source& source = sources[diagnostic.where.source];
        const Place at = place(source.text, diagnostic.where.begin);
        out << printable(source.name) << ':' << at.line << ':' << at.column << ": ";
    }
    if (ansi_colours) out << ansi(diagnostic.severity);
    out << word(diagnostic.severity) << ": ";
    if (ansi_colours) out << "\x1b[0m";
    out << printable(diagnostic.message);
    if (!diagnostic.code.empty()) out << " [" << diagnostic.code << ']';
    out << '\n';
    if (placed) {
        const Source& source = sources[diagnostic.where.source];
        const std::string_view line = line_at(source.text, diagnostic.where.begin);
        const std::size_t column = place(source.text, diagnostic.where.begin).column - 1;
        const std::size_t length = std::max(diagnostic.where.end, diagnostic.where.begin) - diagnostic.where.begin;
        const Excerpt shown = excerpt(line, std::min(column, line.size()), length);
        out << "    " << shown.text << "\n    ";
        if (ansi_colours) out << "\x1b[1;32m";
        out << shown.marks;
        if (ansi_colours) out << "\x1b[0m";
        out << '\n';
    }
    for (const Diagnostic& note : diagnostic.notes) render_one(note, sources, colour, out);
}

std::vector<Diagnostic> in_order(std::vector<Diagnostic> diagnostics) {
    std::ranges::stable_sort(diagnostics, {}, [](const Diagnostic& diagnostic) {
        return std::tuple(diagnostic.where.source.index, diagnostic.where.begin);
    });
    return diagnostics;
}

nlohmann::ordered_json as_json(const Diagnostic& diagnostic, const Sources& sources) {
    nlohmann::ordered_json object = {
        {"file", nullptr}, {"line", nullptr}, {"column", nullptr}, {"end_line", nullptr}, {"end_column", nullptr}};
    if (sources.contains(diagnostic.where.source)) {
        const Source& source = sources[diagnostic.where.source];
        const Place begin = place(source.text, diagnostic.where.begin);
        const Place end = place(source.text, diagnostic.where.end);
        object["file"] = source.name;
        object["line"] = begin.line;
        object["column"] = begin.column;
        object["end_line"] = end.line;
        object["end_column"] = end.column;
    }
    object["severity"] = word(diagnostic.severity);
    object["code"] = diagnostic.code;
    object["message"] = diagnostic.message;
    object["notes"] = nlohmann::ordered_json::array();
    for (const Diagnostic& note : diagnostic.notes) object["notes"].push_back(as_json(note, sources));
    return object;
}

}  // namespace

void render_text(const std::vector<Diagnostic>& diagnostics, const Sources& sources, Colour colour, std::ostream& out) {
    for (const Diagnostic& diagnostic : in_order(diagnostics)) render_one(diagnostic, sources, colour, out);
}

void render_json(const std::vector<Diagnostic>& diagnostics, const Sources& sources, std::ostream& out) {
    nlohmann::ordered_json array = nlohmann::ordered_json::array();
    for (const Diagnostic& diagnostic : in_order(diagnostics)) array.push_back(as_json(diagnostic, sources));
    out << json_text(array) << '\n';
}

}  // namespace grafverif
