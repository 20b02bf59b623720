// SPDX-License-Identifier: MIT
// The table of a trace.
#include "report/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "report/table.hpp"
#include "report/words.hpp"
#include "support/printable.hpp"

namespace grafverif {

namespace {

constexpr std::size_t gutter = 2;   // before the table: the bar of a loop, the star of a cause
constexpr std::size_t between = 2;  // between columns
constexpr std::size_t least_width = 8;

void print_cells(const Cells& cells, const std::string& bar, const TableWidths& widths, std::ostream& out) {
    std::array<std::vector<std::string>, std::tuple_size_v<Cells>> columns;
    std::size_t height = 1;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        columns[i] = wrapped(cells[i], widths[i]);
        height = std::max(height, columns[i].size());
    }
    for (std::size_t line = 0; line < height; ++line) {
        std::string text(bar);
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const std::string cell = line < columns[i].size() ? columns[i][line] : "";
            if (i == 0 && line > 0) std::ranges::replace(text, '*', ' ');
            const std::string blank(widths[i] - std::min(widths[i], columns_of(cell)), ' ');
            text += i == 0 ? blank + cell : cell + blank;
            text += std::string(between, ' ');
        }
        text.erase(text.find_last_not_of(' ') + 1);
        out << printable(text) << '\n';
    }
}

/// As wide as the contents; the widest columns are reduced until all fit.
TableWidths fitting(const ChartRun& run) {
    TableWidths widths{};
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = column_titles[i].size();
    for (const std::size_t index : shown_rows(run)) {
        const Cells row = cells(run, index, index + 1 == run.rows.size());
        for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], columns_of(row[i]));
    }
    const std::size_t room = widest_line - gutter - between * (widths.size() - 1);
    for (std::size_t sum = std::accumulate(widths.begin(), widths.end(), std::size_t{0}); sum > room;) {
        const auto widest = std::ranges::max_element(widths);
        const auto rest = sum - *widest;
        // To the width of the next widest column, or as far as needed.
        std::size_t next = least_width;
        for (auto width = widths.begin(); width != widths.end(); ++width)
            if (width != widest) next = std::max(next, *width);
        const std::size_t needed = room > rest ? room - rest : least_width;
        *widest = std::max({needed, std::min(next, *widest - 1), least_width});
        sum = rest + *widest;
    }
    return widths;
}

bool in_loop(const ChartRun& run, std::size_t index) { return run.loop_from && index >= *run.loop_from; }

/// The visible rows in which a cause begins.
std::set<std::size_t> marked_rows(const ChartRun& run) {
    const std::vector<std::size_t> shown = shown_rows(run);
    std::set<std::size_t> marked;
    for (const ChartRun::Cause& cause : run.causes) {
        const auto row =
            std::ranges::find_if(shown, [&](std::size_t each) { return run.rows[each].moment >= cause.first; });
        if (!shown.empty()) marked.insert(row == shown.end() ? shown.back() : *row);
    }
    return marked;
}

void print_row(const ChartRun& run, std::size_t index, bool complete, bool marked, const TableWidths& widths,
               std::ostream& out) {
    print_cells(cells(run, index, complete), {in_loop(run, index) ? '|' : ' ', marked ? '*' : ' '}, widths, out);
}

void print_paragraph(const std::string& text, std::ostream& out) {
    for (const std::string& line : wrapped(text, widest_line - 4)) out << "    " << printable(line) << '\n';
}

}  // namespace

void print_header(const TableWidths& widths, std::ostream& out) {
    print_cells(column_titles, std::string(gutter, ' '), widths, out);
}

void print_row(const ChartRun& run, std::size_t index, bool complete, const TableWidths& widths, std::ostream& out) {
    print_row(run, index, complete, false, widths, out);
}

void print_trace(const ChartRun& run, std::ostream& out) {
    const TableWidths widths = fitting(run);
    Cells titles = column_titles;
    if (!run.timed) titles[0] = "step";
    print_cells(titles, std::string(gutter, ' '), widths, out);
    const std::set<std::size_t> marked = marked_rows(run);
    for (const std::size_t i : shown_rows(run)) {
        if (run.loop_from == i) out << "+-- from here on, for ever:\n";
        print_row(run, i, i + 1 == run.rows.size(), marked.contains(i), widths, out);
    }
    if (!run.causes.empty())
        print_paragraph(fmt::format("* causes{}: {}", run.causes_exact ? "" : ", approximately", causes_words(run)),
                        out);
    if (const std::string words = left_out_words(run); !words.empty()) print_paragraph(words, out);
}

}  // namespace grafverif
