// SPDX-License-Identifier: MIT
#include "grafverif/support/diagnostic.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string_view>
#include <tuple>
#include <utility>

#include "support/json_text.hpp"
#include "support/overloaded.hpp"
#include "support/printable.hpp"
#include "support/render.hpp"
#include "support/text/documentation.hpp"
#include "support/text/encoding.hpp"

namespace grafverif {

void Diagnostics::add(Diagnostic diagnostic) {
    const bool error = diagnostic.severity == Severity::Error;
    if (error) ++errors_;
    const auto context = context_ ? std::optional(context_()) : std::nullopt;
    // True if `known` reports the same problem in another copy of a replicated declaration. The context is a note that
    // names the copy: the notes of all copies have the same position, but different texts.
    const auto in_other_copy = [&](const Diagnostic& known) {
        return context && !known.notes.empty() && known.notes.back().where.begin == context->where.begin &&
               known.notes.back().message != context->message;
    };
    const auto same = [&](const Diagnostic& known) {
        return known.code == diagnostic.code && known.where.source == diagnostic.where.source &&
               known.where.begin == diagnostic.where.begin &&
               (known.message == diagnostic.message || in_other_copy(known));
    };
    if (std::ranges::any_of(stored_, same)) {
        if (error) ++repeated_;
        return;
    }
    if (context) diagnostic.notes.push_back(*context);
    if (stored_.size() < 2 * limit && distinct_errors() <= limit) stored_.push_back(std::move(diagnostic));
}

Diagnostics::Context Diagnostics::set_context(Context note) { return std::exchange(context_, std::move(note)); }

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

constexpr std::size_t indentation = 4;
constexpr std::size_t least_columns = 20;  // minimum width of source text on narrow terminals
constexpr std::size_t tab_columns = 8;

/// A source line in its printed form.
struct Excerpt {
    std::string text = {};
    std::string marks = {};  ///< spaces and carets; tabs of the source line are kept
};

/// A character of a source line.
struct Cell {
    std::size_t at = 0, bytes = 1;  ///< position and length in the line, in bytes
    std::size_t columns = 1;        ///< width on a terminal if the line is not truncated
    bool marked = false;
};

/// Returns the characters of the line. The marked part of the line starts at byte `column` and has `length` bytes. A
/// tab advances to the next column that is a multiple of eight, as on most terminals.
std::vector<Cell> cells_of(std::string_view line, std::size_t column, std::size_t length) {
    std::vector<Cell> cells;
    for (std::size_t at = 0, reached = indentation; at < line.size(); at += cells.back().bytes) {
        const Glyph glyph = first_glyph(line.substr(at));
        const std::size_t columns = line[at] == '\t' ? tab_columns - reached % tab_columns : glyph.columns;
        cells.push_back({at, glyph.bytes, columns, at >= column && at < column + length});
        reached += columns;
    }
    return cells;
}

/// Returns the range [from, to) of characters to print. With a `…` on each truncated side, the range fits into
/// `available` columns. The range contains the beginning of the marked part and some text before it.
std::pair<std::size_t, std::size_t> window(const std::vector<Cell>& cells, std::size_t first_marked,
                                           std::size_t available) {
    std::size_t whole = 0, before = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        whole += cells[i].columns;
        if (i < first_marked) before += cells[i].columns;
    }
    if (whole <= available) return {0, cells.size()};
    std::size_t from = 0;
    if (before > available * 3 / 4)
        for (; from < first_marked && (before > available / 2 || cells[from].columns == 0); ++from)
            before -= cells[from].columns;
    std::size_t used = (from > 0 ? 1 : 0) + 1, to = from;
    while (to < cells.size() && used + cells[to].columns <= available) used += cells[to++].columns;
    if (to + 1 == cells.size() && used - 1 + cells[to].columns <= available)
        ++to;  // the last character is not followed by `…`
    return {from, to};
}

/// Returns the line, and a second line with at least one caret under the terminal columns of the marked characters. For
/// a long line, only the part near the marked text is examined.
Excerpt excerpt(std::string_view line, std::size_t column, std::size_t length, std::size_t columns) {
    constexpr std::size_t near = 4096;  // in bytes; larger than the printed part of any line
    std::size_t cut = column > near ? column - near : 0;
    // Advances to the start of a character.
    while (cut < column && continues_character(line[cut])) ++cut;
    const bool continues = line.size() > column + near;
    line = line.substr(cut, column - cut + near);
    column -= cut;
    const std::vector<Cell> cells = cells_of(line, column, length);
    const std::size_t available = std::max(columns, indentation + least_columns) - indentation;
    const auto first = std::ranges::find_if(cells, [&](const Cell& cell) { return cell.at >= column; });
    const auto first_marked = static_cast<std::size_t>(first - cells.begin());
    const auto [from, to] = window(cells, first_marked, available);
    Excerpt shown;
    if (from + cut > 0) shown = {"…", " "};
    std::size_t carets = 0;
    for (std::size_t i = from; i < to; ++i) {
        const Cell& cell = cells[i];
        shown.text += printable(line.substr(cell.at, cell.bytes));
        if (cell.marked) carets += cell.columns;
        else if (i < first_marked && line[cell.at] == '\t') shown.marks += '\t';
        else if (i < first_marked) shown.marks.append(cell.columns, ' ');
    }
    if (to < cells.size() || continues) shown.text += "…";
    shown.marks.append(std::max<std::size_t>(carets, 1), '^');
    return shown;
}

void render_one(const Diagnostic& diagnostic, const Sources& sources, Colour colour, std::size_t columns,
                std::ostream& out) {
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
    if (!diagnostic.code.empty())
        out << " [" << (ansi_colours ? terminal_link(diagnostic.code) : diagnostic.code) << ']';
    out << '\n';
    if (placed) {
        const Source& source = sources[diagnostic.where.source];
        const std::string_view line = line_at(source.text, diagnostic.where.begin);
        const std::size_t column = place(source.text, diagnostic.where.begin).column - 1;
        const std::size_t length = std::max(diagnostic.where.end, diagnostic.where.begin) - diagnostic.where.begin;
        const Excerpt shown = excerpt(line, std::min(column, line.size()), length, columns);
        out << "    " << shown.text << "\n    ";
        if (ansi_colours) out << "\x1b[1;32m";
        out << shown.marks;
        if (ansi_colours) out << "\x1b[0m";
        out << '\n';
    }
    for (const Diagnostic& note : diagnostic.notes) render_one(note, sources, colour, columns, out);
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
    render_text(diagnostics, sources, colour, usual_columns, out);
}

void render_text(const std::vector<Diagnostic>& diagnostics, const Sources& sources, Colour colour, std::size_t columns,
                 std::ostream& out) {
    for (const Diagnostic& diagnostic : in_order(diagnostics)) render_one(diagnostic, sources, colour, columns, out);
}

void render_json(const std::vector<Diagnostic>& diagnostics, const Sources& sources, std::ostream& out) {
    nlohmann::ordered_json array = nlohmann::ordered_json::array();
    for (const Diagnostic& diagnostic : in_order(diagnostics)) array.push_back(as_json(diagnostic, sources));
    out << json_text(array) << '\n';
}

}  // namespace grafverif
