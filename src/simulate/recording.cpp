// SPDX-License-Identifier: MIT
#include "simulate/recording.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "simulate/called.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t from = text.find_first_not_of(" \t\r"), to = text.find_last_not_of(" \t\r");
    return from == std::string_view::npos ? "" : text.substr(from, to + 1 - from);
}

bool contains(const ChartRun::State& state, Id<ChartRun::Step> step) {
    return std::ranges::find(state.situation, step) != state.situation.end();
}

}  // namespace

std::string Recording::execute(const Command& command, std::string_view line) {
    const ChartRun::State before = simulation_.recorded_run().moments.back().after;
    const std::size_t commands = simulation_.undoable();
    std::string text(trimmed(line));
    if (const auto* const choice = std::get_if<ChooseCommand>(&command); choice && choice->number > 0) {
        const std::vector<Choice> choices = simulation_.choices();
        // The script contains the command of a choice instead of its number, because the command is more informative.
        if (choice->number <= choices.size()) text = choices[choice->number - 1].command;
    }
    std::string problem = simulation_.execute(command);
    while (!lines_.empty() && lines_.back().commands > simulation_.undoable()) lines_.pop_back();
    const bool moved = simulation_.undoable() > commands;
    const bool is_met = std::holds_alternative<ExpectCommand>(command) && problem.empty();
    if (!moved && !is_met) return problem;
    const std::int64_t passed = simulation_.recorded_run().moments.back().after.time_ms - before.time_ms;
    if (!problem.empty()) text = passed > 0 ? "wait " + duration_text(passed) : "// " + text + ": " + problem;
    lines_.push_back({std::move(text), moved ? claim(before) : "", simulation_.undoable()});
    return problem;
}

std::string Recording::claim(const ChartRun::State& before) const {
    const ChartRun& run = simulation_.recorded_run();
    const ChartRun::State& now = run.moments.back().after;
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    for (const bool active : {true, false})
        for (const Id<ChartRun::Step> step : run.steps.ids())
            if (contains(now, step) == active && contains(before, step) != active)
                add((active ? "" : "not ") + variable_of(run.steps[step]));
    for (const Id<ChartRun::Signal> id : run.signals.ids()) {
        const ChartRun::Signal& signal = run.signals[id];
        const bool of_chart = signal.role == ChartRun::Role::Output || signal.role == ChartRun::Role::Internal;
        const std::int64_t value = now.values[id.index];
        if (!of_chart || value == before.values[id.index]) continue;
        if (signal.type.boolean) add((value != 0 ? "" : "not ") + signal.name);
        else add(fmt::format("{} = {}", signal.name, value));
    }
    return text;
}

std::string Recording::script() const {
    std::string text =
        fmt::format("{} of {}; replay it with `--script`.\n", saved_session, simulation_.recorded_run().name);
    for (const Line& line : lines_)
        text += line.text + "\n" + (line.claim.empty() ? "" : "expect " + line.claim + "\n");
    return text;
}

}  // namespace grafverif
