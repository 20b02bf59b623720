// SPDX-License-Identifier: MIT
#include "report/table.hpp"

#include "report/words.hpp"

namespace grafverif {

namespace {

void append(std::string& list, const std::string& word) { list += (list.empty() ? "" : ", ") + word; }

/// The inputs that have changed since the step before, as they are now.
std::string changed_words(const std::vector<Trace::Signal>& signals, const std::vector<std::int64_t>& before,
                          const std::vector<std::int64_t>& now) {
    std::string list;
    for (std::size_t i = 0; i < signals.size(); ++i)
        if (before[i] != now[i]) append(list, value_words(signals[i].name, signals[i].type, now[i]));
    return list;
}

}  // namespace

std::string cleared_words(const Trace::Step& step) {
    std::string list;
    for (const std::vector<std::string>& evolution : step.fired) {
        std::string names;
        for (const std::string& name : evolution) append(names, name);
        list += (list.empty() ? "" : "; ") + names;
    }
    return list;
}

std::string standing_words(const std::vector<Trace::Signal>& signals, const std::vector<std::int64_t>& values) {
    std::string list;
    for (std::size_t i = 0; i < signals.size(); ++i)
        if (values[i] != 0) append(list, value_words(signals[i].name, signals[i].type, values[i]));
    return list.empty() ? "none" : list;
}

std::string situation_words(const Trace& trace, const Trace::State& state) {
    std::string list;
    for (const std::uint32_t step : state.situation) append(list, trace.short_names[step]);
    return list.empty() ? "none" : list;
}

std::string happening(const Trace& trace, std::size_t index) {
    const Trace::Step& step = trace.steps[index];
    std::string words = step.what;
    if (index > 0) {
        const std::vector<std::int64_t>& before = trace.steps[index - 1].after.internals;
        const std::vector<std::int64_t>& now = step.after.internals;
        for (std::size_t i = 0; i < now.size(); ++i)
            if (before[i] != now[i])
                append(words, change_words(trace.internals[i].name, trace.internals[i].type, before[i], now[i]));
    }
    if (step.component.empty()) return words;
    return words.empty() ? step.component : step.component + ": " + words;
}

Cells cells(const Trace& trace, std::size_t index, bool complete) {
    const Trace::State& now = trace.steps[index].after;
    const bool first = index == 0;
    std::size_t previous = first ? 0 : index - 1;
    while (previous > 0 && !is_shown(trace, previous)) --previous;
    const Trace::State& before = trace.steps[previous].after;
    Cells cells;
    if (first || now.time_ms != before.time_ms) cells[0] = moment_text(trace, now);
    cells[1] = happening(trace, index);
    cells[2] =
        first ? standing_words(trace.inputs, now.inputs) : changed_words(trace.inputs, before.inputs, now.inputs);
    cells[3] = cleared_words(trace.steps[index]);
    if (first || complete || now.situation != before.situation) cells[4] = situation_words(trace, now);
    if (first || complete || now.outputs != before.outputs) cells[5] = standing_words(trace.outputs, now.outputs);
    return cells;
}

}  // namespace grafverif
