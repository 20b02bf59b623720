// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "run/project.hpp"

namespace grafverif {

namespace {

using Kind = Chart::VariableKind;

}  // namespace

ChartRun project(const Chart& chart, ExecutionMode mode) {
    ChartRun run{.name = chart.name};
    ChartRun::Controller controller{.name = chart.name, .mode = mode};
    for (const Id<Chart::Step> step : chart.steps.ids())
        controller.steps.push_back(run.steps.add({name_of(chart, step), "", ""}));
    shorten_names(run.steps);
    for (const Chart::Transition& transition : chart.transitions)
        controller.transitions.push_back(run.transitions.add({transition.name}));
    for (const Chart::Variable& variable : chart.variables) {
        const auto add = [&](ChartRun::Role role) { return run.signals.add({role, variable.name, variable.type}); };
        switch (variable.kind) {
        case Kind::Input: controller.inputs.push_back(add(ChartRun::Role::Input)); break;
        case Kind::Output: controller.outputs.push_back(add(ChartRun::Role::Output)); break;
        case Kind::Internal: controller.internals.push_back(add(ChartRun::Role::Internal)); break;
        }
    }
    controller.images.resize(controller.outputs.size());
    run.controllers.add(std::move(controller));
    return run;
}

ChartRun::State project(const Chart& chart, const State& state, InputValues inputs, std::int64_t time_ms) {
    ChartRun::State projected{.time_ms = time_ms};
    for (const Id<Chart::Step> id : chart.steps.ids())
        if (state.situation[id.index]) projected.situation.push_back({id.index});
    for (const Id<Chart::Variable> id : chart.variables.ids()) {
        switch (chart.variables[id].kind) {
        case Kind::Input: projected.values.push_back(inputs[id.index]); break;
        case Kind::Output: projected.values.push_back(state.outputs[id.index]); break;
        case Kind::Internal: projected.values.push_back(state.values[id.index]); break;
        }
    }
    return projected;
}

void append_instant(ChartRun& run, std::string what, const std::vector<std::vector<Id<Chart::Transition>>>& fired,
                    ChartRun::State after) {
    ChartRun::Event moment;
    const auto has_acts = [](const ChartRun::Event& earlier) { return !earlier.acts.empty(); };
    const bool is_first = std::ranges::none_of(run.moments, has_acts);
    ChartRun::Row row{.kind = ChartRun::Kind::Controller, .what = std::move(what), .moment = run.moments.size()};
    if (is_first && fired.size() == 1 && row.what.empty()) row.what = "first evolution";
    for (const std::vector<Id<Chart::Transition>>& evolution : fired) {
        ChartRun::Act act{.controller = {0}, .evolves = true};
        for (const Id<Chart::Transition> id : evolution) act.fired.push_back({id.index});
        if (!act.fired.empty()) row.fired.push_back(act.fired);
        moment.acts.push_back(std::move(act));
    }
    moment.after = std::move(after);
    run.moments.push_back(std::move(moment));
    run.rows.push_back(std::move(row));
}

}  // namespace grafverif
