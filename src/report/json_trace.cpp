// SPDX-License-Identifier: MIT
#include "report/json_trace.hpp"

namespace grafverif {

namespace {

using Json = nlohmann::ordered_json;

Json values(const std::vector<Trace::Signal>& signals, const std::vector<std::int64_t>& list) {
    Json object = Json::object();
    for (std::size_t i = 0; i < signals.size(); ++i)
        object[signals[i].name] = signals[i].type.boolean ? Json(list[i] != 0) : Json(list[i]);
    return object;
}

Json step(const Trace& trace, const Trace::Step& step) {
    Json fired = Json::array();
    for (const std::vector<std::string>& evolution : step.fired)
        for (const std::string& transition : evolution) fired.push_back(transition);
    Json situation = Json::array();
    for (const std::uint32_t active : step.after.situation) situation.push_back(trace.steps_of_charts[active]);
    return {{"time", trace.timed ? Json(step.after.time_ms) : Json(nullptr)},
            {"kind", word(step.kind)},
            {"component", step.component.empty() ? Json(nullptr) : Json(step.component)},
            {"inputs", values(trace.inputs, step.after.inputs)},
            {"fired", std::move(fired)},
            {"situation", std::move(situation)},
            {"outputs", values(trace.outputs, step.after.outputs)}};
}

}  // namespace

Json trace_json(const Trace& trace) {
    Json steps = Json::array();
    for (const Trace::Step& each : trace.steps) steps.push_back(step(trace, each));
    return {{"loop_from", trace.loop_from ? Json(*trace.loop_from) : Json(nullptr)}, {"steps", std::move(steps)}};
}

}  // namespace grafverif
