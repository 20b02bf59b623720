// SPDX-License-Identifier: MIT
#include "report/json_trace.hpp"

namespace grafverif {

namespace {

using Json = nlohmann::ordered_json;

Json values(const ChartRun& run, ChartRun::Role role, const ChartRun::State& state) {
    Json object = Json::object();
    for (const Id<ChartRun::Signal> id : signals_of(run, role)) {
        const std::int64_t value = state.values[id.index];
        object[run.signals[id].name] = run.signals[id].type.boolean ? Json(value != 0) : Json(value);
    }
    return object;
}

Json step(const ChartRun& run, const ChartRun::Row& row) {
    const ChartRun::State& after = run.after(row);
    Json fired = Json::array();
    for (const std::vector<Id<ChartRun::Transition>>& evolution : row.fired)
        for (const Id<ChartRun::Transition> id : evolution) fired.push_back(run.transitions[id].name);
    Json situation = Json::array();
    for (const Id<ChartRun::Step> active : after.situation) situation.push_back(run.steps[active].full_name);
    return {{"time", run.timed ? Json(after.time_ms) : Json(nullptr)},
            {"kind", word(row.kind)},
            {"component", row.component.empty() ? Json(nullptr) : Json(row.component)},
            {"inputs", values(run, ChartRun::Role::Input, after)},
            {"fired", std::move(fired)},
            {"situation", std::move(situation)},
            {"outputs", values(run, ChartRun::Role::Output, after)}};
}

}  // namespace

Json trace_json(const ChartRun& run) {
    Json steps = Json::array();
    for (const ChartRun::Row& row : run.rows) steps.push_back(step(run, row));
    return {{"loop_from", run.loop_from ? Json(*run.loop_from) : Json(nullptr)}, {"steps", std::move(steps)}};
}

}  // namespace grafverif
