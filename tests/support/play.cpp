// SPDX-License-Identifier: MIT
#include "support/play.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "read/text.hpp"

namespace grafverif {

namespace {

std::string rendered(const Diagnostics& diagnostics, const Sources& sources) {
    std::ostringstream out;
    render_text(diagnostics.all(), sources, Colour::Plain, out);
    return out.str();
}

}  // namespace

Chart chart(std::string_view text) {
    Diagnostics diagnostics;
    Sources sources;
    const Id<Source> file = sources.add({"chart.grafcet", "grafcet chart {\n" + std::string(text) + "\n}\n"});
    const auto model = read_text(file, sources, {}, diagnostics);
    if (!model) throw std::runtime_error(rendered(diagnostics, sources));
    return *model->charts.begin();
}

Equations equations(std::string_view text) {
    Diagnostics diagnostics;
    auto result = derive(chart(text), diagnostics);
    if (!result) throw std::runtime_error(diagnostics.all().front().message);
    EXPECT_EQ(verify(*result), std::vector<std::string>{});
    return std::move(*result);
}

std::vector<std::string> refusals(std::string_view text) {
    Diagnostics diagnostics;
    EXPECT_FALSE(derive(chart(text), diagnostics).has_value());
    std::vector<std::string> messages;
    for (const Diagnostic& diagnostic : diagnostics.all())
        messages.push_back("[" + diagnostic.code + "] " + diagnostic.message);
    return messages;
}

Play play(std::string_view text, ExecutionMode mode) {
    Play result{chart(text), mode, {}};
    result.state = power_on(result.chart);
    return result;
}

namespace {

Id<Chart::Variable> variable(const Chart& chart, std::string_view name) {
    for (const Id<Chart::Variable> id : chart.variables.ids())
        if (chart.variables[id].name == name) return id;
    throw std::runtime_error("unknown variable " + std::string(name));
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

}  // namespace

Cycle run(Play& play, std::string_view inputs) {
    std::vector<std::int64_t> values(play.chart.variables.size());
    std::istringstream words{std::string(inputs)};
    for (std::string word; words >> word;) {
        const std::size_t equals = word.find('=');
        values[variable(play.chart, word.substr(0, equals)).index] =
            equals == std::string::npos ? 1 : std::stoll(word.substr(equals + 1));
    }
    Cycle result = cycle(play.chart, play.state, values, play.mode);
    play.state = result.state;
    return result;
}

void wait(Play& play, std::int64_t milliseconds) { play.state = pass_time(std::move(play.state), milliseconds); }

std::string situation(const Play& play) {
    std::vector<std::string> names;
    for (const Id<Chart::Step> id : play.chart.steps.ids())
        if (play.state.situation[id.index]) names.push_back(play.chart.steps[id].name);
    return listed(names);
}

std::string outputs(const Play& play) {
    std::vector<std::string> names;
    for (const Id<Chart::Variable> id : play.chart.variables.ids()) {
        const Chart::Variable& output = play.chart.variables[id];
        const std::int64_t written = play.state.outputs[id.index];
        if (output.kind != Chart::VariableKind::Output || written == 0) continue;
        names.push_back(output.type.boolean ? output.name : output.name + "=" + std::to_string(written));
    }
    return listed(names);
}

std::int64_t value(const Play& play, std::string_view name) {
    return play.state.values[variable(play.chart, name).index];
}

std::string fired(const Play& play, const Cycle& cycle) {
    std::string text;
    for (const auto& evolution : cycle.fired) {
        std::vector<std::string> names;
        for (const Id<Chart::Transition> transition : evolution)
            names.push_back(play.chart.transitions[transition].name);
        text += listed(names) + "; ";
    }
    return text;
}

}  // namespace grafverif
