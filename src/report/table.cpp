// SPDX-License-Identifier: MIT
#include "report/table.hpp"

#include <algorithm>
#include <vector>

#include "report/trace_text.hpp"
#include "support/printable.hpp"

namespace grafverif {

namespace {

void append(std::string& list, const std::string& word) { list += (list.empty() ? "" : ", ") + word; }

/// Returns the signals with the role `role` whose values differ between the two states.
std::vector<Id<ChartRun::Signal>> changed(const ChartRun& run, ChartRun::Role role, const ChartRun::State& before,
                                          const ChartRun::State& now) {
    std::vector<Id<ChartRun::Signal>> found = signals_of(run, role);
    std::erase_if(found, [&](Id<ChartRun::Signal> id) { return before.values[id.index] == now.values[id.index]; });
    return found;
}

}  // namespace

std::string cleared_text(const ChartRun& run, const ChartRun::Row& row) {
    std::string list;
    for (const std::vector<Id<ChartRun::Transition>>& evolution : row.fired) {
        std::string names;
        for (const Id<ChartRun::Transition> id : evolution) append(names, run.transitions[id].name);
        list += (list.empty() ? "" : "; ") + names;
    }
    return list;
}

std::string standing_text(const ChartRun& run, ChartRun::Role role, const ChartRun::State& state) {
    std::string list;
    for (const Id<ChartRun::Signal> id : signals_of(run, role))
        if (state.values[id.index] != 0) append(list, value_text(run.signals[id], state.values[id.index]));
    return list.empty() ? "none" : list;
}

std::string situation_text(const ChartRun& run, const ChartRun::State& state) {
    std::string list;
    for (const Id<ChartRun::Step> step : state.situation) append(list, run.steps[step].short_name);
    return list.empty() ? "none" : list;
}

std::string happening(const ChartRun& run, std::size_t index) {
    const ChartRun::Row& row = run.rows[index];
    std::string words = row.what;
    if (index > 0) {
        const ChartRun::State &before = run.after(run.rows[index - 1]), &now = run.after(row);
        for (const Id<ChartRun::Signal> id : changed(run, ChartRun::Role::Internal, before, now))
            append(words, change_text(run.signals[id], before.values[id.index], now.values[id.index]));
    }
    if (row.component.empty()) return words;
    return words.empty() ? row.component : row.component + ": " + words;
}

Cells cells(const ChartRun& run, std::size_t index, bool complete) {
    const ChartRun::State& now = run.after(run.rows[index]);
    const bool first = index == 0;
    std::size_t previous = first ? 0 : index - 1;
    while (previous > 0 && !is_shown(run, previous)) --previous;
    const ChartRun::State& before = run.after(run.rows[previous]);
    Cells cells;
    if (first || now.time_ms != before.time_ms) cells[0] = event_text(run, now);
    cells[1] = happening(run, index);
    if (first) cells[2] = standing_text(run, ChartRun::Role::Input, now);
    for (const Id<ChartRun::Signal> id : changed(run, ChartRun::Role::Input, before, now))
        append(cells[2], value_text(run.signals[id], now.values[id.index]));
    cells[3] = cleared_text(run, run.rows[index]);
    if (first || complete || now.situation != before.situation) cells[4] = situation_text(run, now);
    if (first || complete || !changed(run, ChartRun::Role::Output, before, now).empty())
        cells[5] = standing_text(run, ChartRun::Role::Output, now);
    return cells;
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width, std::optional<std::size_t> later_width) {
    std::vector<std::string> lines;
    for (std::size_t fit = bytes_within(text, width); fit < text.size(); fit = bytes_within(text, width)) {
        const std::size_t blank = text.rfind(' ', fit);
        const bool at_blank = blank != std::string_view::npos && blank > 0;
        const std::size_t end = at_blank ? blank : std::max(fit, first_glyph(text).bytes);
        lines.emplace_back(text.substr(0, end));
        width = later_width.value_or(width);
        text.remove_prefix(at_blank ? end + 1 : end);
    }
    if (!text.empty() || lines.empty()) lines.emplace_back(text);
    return lines;
}

}  // namespace grafverif
