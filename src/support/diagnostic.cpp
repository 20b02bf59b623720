// SPDX-License-Identifier: MIT
#include "grafverif/support/diagnostic.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string_view>
#include <tuple>

#include "grafverif/support/overloaded.hpp"

namespace grafverif {

void Diagnostics::add(Diagnostic diagnostic) {
    if (diagnostic.severity == Severity::Error) ++errors_;
    if (stored_.size() < 2 * limit && errors_ <= limit) stored_.push_back(std::move(diagnostic));
}

namespace {

std::string_view word(Severity severity) {
    switch (severity) {
    case Severity::Error:   return "error";
    case Severity::Warning: return "warning";
    case Severity::Note:    return "note";
    }
    unreachable();
}

std::string_view ansi(Severity severity) {
    switch (severity) {
    case Severity::Error:   return "\x1b[1;31m";
    case Severity::Warning: return "\x1b[1;35m";
    case Severity::Note:    return "\x1b[1;36m";
    }
    unreachable();
}

constexpr std::size_t clip_columns = 100;

/// A source line as shown: at most `clip_columns` bytes around the marked part, cut at character boundaries.
struct Excerpt {
    std::string text = {};
    std::string marks = {};   ///< blanks, tabs kept, then carets
};

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// The bytes of the UTF-8 character that `text` begins with; 0 where it begins with none.
std::size_t character(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    const std::size_t length = first < 0x80 ? 1 : first >= 0xC2 && first < 0xE0 ? 2 : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xF0 && first < 0xF5 ? 4 : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if (!continues_character(text[i])) return 0;
    return length;
}

/// `text` with `?` for each byte that a terminal must not see: controls and what is no UTF-8.
std::string printable(std::string_view text) {
    std::string shown;
    while (!text.empty()) {
        const std::size_t length = character(text);
        const bool control = length == 1 && (static_cast<unsigned char>(text[0]) < 0x20 || text[0] == 0x7F) && text[0] != '\t';
        if (length == 0 || control) shown += '?';
        else shown += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return shown;
}

Excerpt excerpt(std::string_view line, std::size_t column, std::size_t length) {
    std::size_t from = column > clip_columns * 3 / 4 ? column - clip_columns / 2 : 0;
    while (from > 0 && from < line.size() && continues_character(line[from])) --from;
    std::size_t to = std::min(line.size(), from + clip_columns);
    while (to < line.size() && continues_character(line[to])) ++to;

    Excerpt shown;
    if (from > 0) shown.text = "...";
    shown.marks.assign(shown.text.size(), ' ');
    shown.text += printable(line.substr(from, to - from));
    if (to < line.size()) shown.text += "...";
    for (std::size_t at = from; at < std::min(column, to); ++at) {
        if (line[at] == '\t') shown.marks += '\t';
        else if (!continues_character(line[at])) shown.marks += ' ';
    }
    std::size_t carets = 0;
    for (std::size_t at = column; at < std::min(column + length, to); ++at)
        if (!continues_character(line[at])) ++carets;
    shown.marks.append(std::max<std::size_t>(carets, 1), '^');
    return shown;
}

void render_one(const Diagnostic& diagnostic, const Sources& sources, Colour colour, std::ostream& out) {
    const bool ansi_colours = colour == Colour::Ansi;
    const bool placed = sources.contains(diagnostic.where.source);
    if (placed) {
        const Source& source = sources[diagnostic.where.source];
        const Place at = place(source.text, diagnostic.where.begin);
        out << source.name << ':' << at.line << ':' << at.column << ": ";
    }
    if (ansi_colours) out << ansi(diagnostic.severity);
    out << word(diagnostic.severity) << ": ";
    if (ansi_colours) out << "\x1b[0m";
    out << diagnostic.message;
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
    nlohmann::ordered_json object = {{"file", nullptr}, {"line", nullptr}, {"column", nullptr},
                                     {"end_line", nullptr}, {"end_column", nullptr}};
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
    out << array.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

}  // namespace grafverif
