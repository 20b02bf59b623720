// SPDX-License-Identifier: MIT
#include "report/json_trace.hpp"

#include <optional>
#include <vector>

#include "report/trace_text.hpp"

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
    for (const Id<ChartRun::Step> active : after.situation) situation.push_back(run.steps[active].full_name());
    return {{"time", run.timed ? Json(after.time_ms) : Json(nullptr)},
            {"kind", word(row.kind)},
            {"component", row.component.empty() ? Json(nullptr) : Json(row.component)},
            {"inputs", values(run, ChartRun::Role::Input, after)},
            {"fired", std::move(fired)},
            {"situation", std::move(situation)},
            {"outputs", values(run, ChartRun::Role::Output, after)},
            {"moment", row.moment}};
}

/// Returns an id as a JSON number, which is the index in its table; null if the id is invalid.
template <class T>
Json index_of(Id<T> id) {
    return id.valid() ? Json(id.index) : Json(nullptr);
}
template <class T>
Json indices(const std::vector<Id<T>>& ids) {
    Json list = Json::array();
    for (const Id<T> id : ids) list.push_back(index_of(id));
    return list;
}
template <class T>
Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

template <class T, class Write>
Json listed(const T& entities, Write write) {
    Json list = Json::array();
    for (const auto& entity : entities) list.push_back(write(entity));
    return list;
}

Json controller_json(const ChartRun::Controller& controller) {
    return {{"name", controller.name},
            {"mode", controller.mode == ExecutionMode::EveryCycle ? "every-cycle" : "stability-search"},
            {"steps", indices(controller.steps)},
            {"transitions", indices(controller.transitions)},
            {"inputs", indices(controller.inputs)},
            {"outputs", indices(controller.outputs)},
            {"images", indices(controller.images)},
            {"internals", indices(controller.internals)},
            {"timers", indices(controller.timers)}};
}

Json signal_json(const ChartRun::Signal& signal) {
    Json object = {{"name", signal.name}, {"role", word(signal.role)}};
    if (signal.type.boolean) return object;
    object["range"] = {signal.type.low, signal.type.high};
    return object;
}

Json act_json(const ChartRun::Act& act) {
    Json does = Json::array();
    const auto add = [&does](bool done, const char* what) {
        if (done) does.push_back(what);
    };
    add(act.begins, "begin");
    add(act.starts, "start");
    add(act.samples, "sample");
    add(act.evolves, "evolve");
    add(act.writes == ChartRun::Act::Writes::Yes, "write");
    add(act.writes == ChartRun::Act::Writes::IfStable, "write-if-stable");
    Json object = {{"controller", index_of(act.controller)},
                   {"does", std::move(does)},
                   {"inputs", act.inputs},
                   {"timers", act.timers},
                   {"fired", indices(act.fired)},
                   {"stable", or_null(act.stable)}};
    if (act.elapsed_ms) object["elapsed"] = *act.elapsed_ms;
    return object;
}

/// Returns the values that have changed since the state `before`, each with the index of its signal. If `before` is
/// null, returns all values.
Json values_json(const ChartRun::State* before, const ChartRun::State& now) {
    Json list = Json::array();
    for (std::size_t i = 0; i < now.values.size(); ++i)
        if (before == nullptr || before->values[i] != now.values[i]) list.push_back({i, now.values[i]});
    return list;
}

Json event_json(const ChartRun& run, std::size_t index) {
    const ChartRun::Event& moment = run.moments[index];
    const ChartRun::State* const before = index == 0 ? nullptr : &run.moments[index - 1].after;
    Json object = {{"time", moment.after.time_ms},
                   {"kind", word(moment.kind)},
                   {"internal", moment.internal},
                   {"acts", listed(moment.acts, act_json)},
                   {"instance", index_of(moment.instance)},
                   {"location", or_null(moment.location)},
                   {"timer", index_of(moment.timer)},
                   {"timer_holds", moment.timer.valid() ? Json(moment.timer_holds) : Json(nullptr)},
                   {"values", values_json(before, moment.after)}};
    if (before == nullptr || before->situation != moment.after.situation)
        object["situation"] = indices(moment.after.situation);
    return object;
}

Json cause_json(const ChartRun& run, const ChartRun::Cause& cause) {
    return {{"signal", index_of(cause.signal)},
            {"step", index_of(cause.step)},
            {"instance", index_of(cause.instance)},
            {"timer", index_of(cause.timer)},
            {"location", cause.instance.valid() ? Json(cause.location) : Json(nullptr)},
            {"value", cause.value},
            {"from", cause.first},
            {"to", cause.last},
            {"words", cause_text(run, cause)}};
}

}  // namespace

Json run_json(const ChartRun& run) {
    Json moments = Json::array();
    for (std::size_t i = 0; i < run.moments.size(); ++i) moments.push_back(event_json(run, i));
    Json made = {{"version", 1},
                 {"name", run.name},
                 {"timed", run.timed},
                 {"controllers", listed(run.controllers, controller_json)},
                 {"steps", listed(run.steps,
                                  [](const ChartRun::Step& step) {
                                      return Json{{"name", step.name.text()},
                                                  {"full_name", step.full_name()},
                                                  {"short_name", step.short_name}};
                                  })},
                 {"transitions", listed(run.transitions,
                                        [](const ChartRun::Transition& each) {
                                            return Json::object({{"name", each.name}});
                                        })},
                 {"timers", listed(run.timers,
                                   [](const ChartRun::Timer& timer) {
                                       return Json{
                                           {"name", timer.name},
                                           {"watched", timer.watched.empty() ? Json(nullptr) : Json(timer.watched)},
                                           {"rise", timer.rise_ms},
                                           {"fall", timer.fall_ms}};
                                   })},
                 {"signals", listed(run.signals, signal_json)},
                 {"instances",
                  listed(run.instances,
                         [](const ChartRun::Instance& each) {
                             return Json{{"name", each.name}, {"kind", word(each.kind)}, {"locations", each.locations}};
                         })},
                 {"moments", std::move(moments)},
                 {"loop", or_null(run.loop)}};
    if (!run.causes.empty()) {
        const auto each = [&run](const ChartRun::Cause& cause) { return cause_json(run, cause); };
        made["causes"] = {{"exact", run.causes_exact}, {"values", listed(run.causes, each)}};
    }
    if (!run.left_out.empty()) made["left_out"] = run.left_out;
    const auto value = [&run](const ChartRun::Counterfactual& each) {
        return Json{{"moment", each.moment},
                    {"signal", index_of(each.signal)},
                    {"timer", index_of(each.timer)},
                    {"words", counterfactual_text(run, each)}};
    };
    if (!run.counterfactual_values.empty()) made["left_out_values"] = listed(run.counterfactual_values, value);
    return made;
}

Json trace_json(const ChartRun& run) {
    Json steps = Json::array();
    for (const ChartRun::Row& row : run.rows) steps.push_back(step(run, row));
    return {{"loop_from", or_null(run.loop_from)}, {"steps", std::move(steps)}, {"run", run_json(run)}};
}

}  // namespace grafverif
