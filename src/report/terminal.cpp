// SPDX-License-Identifier: MIT
// Prints the table of a trace.
#include "report/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "report/table.hpp"
#include "report/trace_text.hpp"
#include "support/printable.hpp"

namespace grafverif {

namespace {

constexpr std::size_t gutter = 2;      // number of characters before each row: bar of a loop, star of a cause
constexpr std::size_t column_gap = 2;  // number of blanks between columns
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
            text += std::string(column_gap, ' ');
        }
        text.erase(text.find_last_not_of(' ') + 1);
        out << printable(text) << '\n';
    }
}

/// Returns the widths of the columns. Each column is as wide as its longest entry. If the table does not fit into a
/// line, the widest columns are reduced.
TableWidths fitting(const ChartRun& run) {
    TableWidths widths{};
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = column_titles[i].size();
    for (const std::size_t index : shown_rows(run)) {
        const Cells row = cells(run, index, index + 1 == run.rows.size());
        for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], columns_of(row[i]));
    }
    const std::size_t available = widest_line - gutter - column_gap * (widths.size() - 1);
    for (std::size_t sum = std::accumulate(widths.begin(), widths.end(), std::size_t{0}); sum > available;) {
        const auto widest = std::ranges::max_element(widths);
        const auto rest = sum - *widest;
        // Reduces the widest column to the width of the second widest column, or less if the table already fits after a
        // smaller reduction.
        std::size_t next = least_width;
        for (auto width = widths.begin(); width != widths.end(); ++width)
            if (width != widest) next = std::max(next, *width);
        const std::size_t needed = available > rest ? available - rest : least_width;
        *widest = std::max({needed, std::min(next, *widest - 1), least_width});
        sum = rest + *widest;
    }
    return widths;
}

bool in_loop(const ChartRun& run, std::size_t index) { return run.loop_from && index >= *run.loop_from; }

/// Returns the indices of the displayed rows in which a cause of the violation begins.
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

/// The printed form of a row of the run.
struct Line {
    std::size_t row = 0;
    Cells cells = {};
    std::int64_t time_ms = 0;
    bool in_loop = false, marked = false;

    std::string bar() const { return {in_loop ? '|' : ' ', marked ? '*' : ' '}; }
};

/// True if `later` has the same entries as `line`, except that its time is later by `delay_ms`.
bool repeats(const Line& line, const Line& later, std::int64_t delay_ms) {
    return later.time_ms - line.time_ms == delay_ms && line.cells[0].empty() == later.cells[0].empty() &&
           std::equal(line.cells.begin() + 1, line.cells.end(), later.cells.begin() + 1) &&
           line.in_loop == later.in_loop && !line.marked && !later.marked;
}

/// A sequence of `period` lines that is repeated: it occurs `copies` times in succession.
struct Repetition {
    std::size_t period = 1, copies = 1;
};

/// Returns the repetition with at least three copies that starts at `begin` and covers the most lines. If no repetition
/// starts at `begin`, returns a single line.
Repetition repetition(const std::vector<Line>& lines, std::size_t begin) {
    constexpr std::size_t longest_period = 100;
    Repetition best;
    if (lines[begin].cells[0].empty()) return best;
    for (std::size_t period = 1; period <= longest_period && begin + 3 * period <= lines.size(); ++period) {
        const std::int64_t delay_ms = lines[begin + period].time_ms - lines[begin].time_ms;
        std::size_t same = 0;
        while (delay_ms > 0 && begin + same + period < lines.size() &&
               repeats(lines[begin + same], lines[begin + same + period], delay_ms))
            ++same;
        const std::size_t copies = 1 + same / period;
        if (copies >= 3 && copies * period > best.copies * best.period) best = {period, copies};
    }
    return best;
}

void print_paragraph(const std::string& text, std::ostream& out) {
    for (const std::string& line : wrapped(text, widest_line - 4)) out << "    " << printable(line) << '\n';
}

}  // namespace

void print_header(const TableWidths& widths, std::ostream& out) {
    print_cells(column_titles, std::string(gutter, ' '), widths, out);
}

void print_row(const ChartRun& run, std::size_t index, bool complete, const TableWidths& widths, std::ostream& out) {
    print_cells(cells(run, index, complete), {in_loop(run, index) ? '|' : ' ', ' '}, widths, out);
}

void print_trace(const ChartRun& run, std::ostream& out) {
    const TableWidths widths = fitting(run);
    Cells titles = column_titles;
    if (!run.timed) titles[0] = "step";
    print_cells(titles, std::string(gutter, ' '), widths, out);
    const std::set<std::size_t> marked = marked_rows(run);
    std::vector<Line> lines;
    for (const std::size_t i : shown_rows(run))
        lines.push_back({i, cells(run, i, i + 1 == run.rows.size()), run.after(run.rows[i]).time_ms, in_loop(run, i),
                         marked.contains(i)});
    for (std::size_t begin = 0; begin < lines.size();) {
        const auto [period, copies] = run.timed ? repetition(lines, begin) : Repetition();
        for (std::size_t k = begin; k < begin + period; ++k) {
            if (run.loop_from == lines[k].row) out << "+-- repeated forever from here:\n";
            print_cells(lines[k].cells, lines[k].bar(), widths, out);
        }
        if (copies > 1)
            out << fmt::format("{}{}  repeated {} times, every {}, until {}\n", lines[begin].bar(),
                               std::string(widths[0], ' '), copies - 1,
                               seconds_text(lines[begin + period].time_ms - lines[begin].time_ms),
                               seconds_text(lines[begin + period * copies - 1].time_ms));
        begin += period * copies;
    }
    if (!run.causes.empty())
        print_paragraph(fmt::format("* causes{}: {}", run.causes_exact ? "" : ", approximately", causes_text(run)),
                        out);
    if (const std::string words = counterfactual_text(run); !words.empty()) print_paragraph(words, out);
}

}  // namespace grafverif
