// SPDX-License-Identifier: MIT
#include "page/data.hpp"

#include <algorithm>
#include <utility>

#include "explain/violation.hpp"
#include "page/scans.hpp"
#include "page/terms.hpp"
#include "report/json_trace.hpp"
#include "report/report.hpp"
#include "report/table.hpp"
#include "report/terminal.hpp"
#include "support/json_text.hpp"

namespace grafverif {

namespace {

using Json = nlohmann::ordered_json;

/// For each chart or program of the page: the values of the program's statements; empty for a chart.
using AllScans = std::vector<std::optional<ProgramScans>>;

/// Returns the data of the chart with the index `place` on the page. `chart` is this chart, or the same chart with
/// other values of constants.
Json chart_entry(std::size_t place, const ChartContent& content, const Chart& chart) {
    const ElementIds ids = element_ids(chart, content.prefix);
    Json one = {{"figure", "chart-" + std::to_string(place)},
                {"ids",
                 {{"steps", ids.steps},
                  {"transitions", ids.transitions},
                  {"conditions", ids.conditions},
                  {"continuous", ids.continuous},
                  {"stored", ids.stored},
                  {"forcing", ids.forcing}}}};
    one.update(chart_json(chart));
    return one;
}

Json charts_json(const PageContent& content, const AllScans& programs) {
    Json list = Json::array();
    for (const ChartContent& each : content.charts) {
        Json one = chart_entry(list.size(), each, drawn_chart(content, each));
        if (const auto& program = programs[list.size()]) {
            for (Json& transition : one["transitions"]) transition.erase("condition");
            one["program"] = program->json();
            one["program"]["listing"] = "program-" + std::to_string(list.size());
        }
        list.push_back(std::move(one));
    }
    return list;
}

/// Returns, for each controller of a run, the scans of its program, or null if the controller is a chart.
Json scans_json(const ChartRun& run, const Playable& playable, AllScans& programs, std::size_t& remaining) {
    Json list = Json::array();
    for (const std::size_t chart : playable.charts) {
        const Id<ChartRun::Controller> controller{static_cast<std::uint32_t>(list.size())};
        list.push_back(programs[chart] ? programs[chart]->scans(run, controller, remaining) : Json(nullptr));
    }
    return list;
}

Json rows_json(const ChartRun& run) {
    Json rows = Json::array();
    for (std::size_t k = 0; k < run.rows.size(); ++k)
        rows.push_back({{"moment", run.rows[k].moment},
                        {"words", happening(run, k)},
                        {"cleared", cleared_text(run, run.rows[k])},
                        {"shown", is_shown(run, k)}});
    return rows;
}

Json conditions_json(const ChartRun& run) {
    Json list = Json::array();
    for (const ChartRun::Controller& controller : run.controllers) {
        Json timers = Json::array();
        for (const std::optional<std::size_t>& timer : controller.conditions)
            timers.push_back(timer ? Json(*timer) : Json(nullptr));
        list.push_back(std::move(timers));
    }
    return list;
}

Json inside_json(const ChartRun& run, const Playable& playable) {
    Json list = Json::array();
    for (std::size_t k = 1; k + 1 < run.moments.size() && !playable.property.empty(); ++k)
        if (run.moments[k].move == run.moments[k + 1].move) list.push_back(k);
    return list;
}

const Model& model_of(const PageContent& content, const Playable& playable) {
    return playable.model != nullptr ? *playable.model : content.model;
}

std::optional<SentenceViolation> violation_in(const PageContent& content, const Playable& playable) {
    if (playable.kind != "counterexample" || !content.loop.valid()) return {};
    const Model& model = model_of(content, playable);
    const ClosedLoop& loop = model.loops[content.loop];
    const auto property = std::ranges::find(loop.properties, playable.property, &Property::name);
    if (property == loop.properties.end() || property->pattern != Pattern::Watched) return {};
    std::vector<std::string> terms;
    for (const Id<Expr> operand : property->operands) terms.push_back(term_text(model, loop, operand));
    return violation_of(property->watch, terms, *playable.run);
}

Json violation_json(const std::optional<SentenceViolation>& violation) {
    if (!violation) return nullptr;
    Json steps = Json::array();
    for (const SentenceViolation::Step& step : violation->steps)
        steps.push_back({{"moment", step.moment ? Json(*step.moment) : Json(nullptr)}, {"words", step.words}});
    return {{"moment", violation->moment}, {"steps", std::move(steps)}};
}

/// Removes the moves of observer automata from a run, because observers do not change the state of the closed loop.
void omit_observers(ChartRun& run, std::optional<SentenceViolation>& violation) {
    std::vector<ChartRun::Event> kept;
    // For each event of the original run: the index in `kept` of the last kept event that is not later.
    std::vector<std::size_t> places;
    for (ChartRun::Event& moment : run.moments) {
        if (moment.kind != ChartRun::Kind::Observer) kept.push_back(std::move(moment));
        places.push_back(kept.size() - 1);
    }
    if (kept.size() == places.size()) {
        run.moments = std::move(kept);
        return;
    }
    const auto move = [&](std::size_t& moment) { moment = places[moment]; };
    if (run.loop) run.loop = places[*run.loop - 1] + 1;
    for (ChartRun::Row& row : run.rows) move(row.moment);
    for (ChartRun::Cause& cause : run.causes) move(cause.first), move(cause.last);
    for (std::size_t& moment : run.left_out) move(moment);
    for (ChartRun::Counterfactual& each : run.counterfactual_values) move(each.moment);
    run.moments = std::move(kept);
    if (!violation) return;
    move(violation->moment);
    for (SentenceViolation::Step& step : violation->steps)
        if (step.moment) move(*step.moment);
}

Json plant_json(const PageContent& content) {
    Json figures = Json::object();
    if (!content.loop.valid()) return figures;
    for (const ClosedLoop::Instance& instance : content.model.loops[content.loop].instances)
        figures[instance.name] = component_figure(instance.component);
    return figures;
}

Json initial_json(const PageContent& content, const Playable& playable) {
    Json places = Json::object();
    if (!content.loop.valid()) return places;
    for (const ClosedLoop::Instance& instance : model_of(content, playable).loops[content.loop].instances)
        places[instance.name] = instance.initial.index;
    for (const auto& [instance, location] : playable.initial)
        places[instance] = location ? Json(*location) : Json(nullptr);
    return places;
}

}  // namespace

std::vector<const Property*> left_out(const PageContent& content) {
    std::vector<const Property*> list;
    if (!content.loop.valid()) return list;
    for (const Property& property : content.model.loops[content.loop].properties) {
        const bool requested =
            content.requested.empty() || std::ranges::find(content.requested, property.name) != content.requested.end();
        if (requested && !has_result(content.report, property)) list.push_back(&property);
    }
    return list;
}

std::string evidence_name(const PageContent& content, const Analysis& analysis, const Finding& finding) {
    std::string name = finding.code;
    if (content.charts.size() > 1) name = analysis.chart + ":" + name;
    if (!finding.subject.empty()) name += ":" + finding.subject;
    const auto place = &finding - analysis.findings.data();
    const auto same = [&](const Finding& other) {
        return other.code == finding.code && other.subject == finding.subject;
    };
    const auto before = std::count_if(analysis.findings.begin(), analysis.findings.begin() + place, same);
    return before == 0 ? name : name + ":" + std::to_string(before + 1);
}

std::vector<Playable> playable_runs(const PageContent& content) {
    std::vector<Playable> runs;
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < content.charts.size(); ++k) all.push_back(k);
    std::size_t remaining = longest_playable;
    const auto add = [&](Playable run) {
        if (!can_be_played(*run.run) || run.run->moments.size() > remaining) return;
        remaining -= run.run->moments.size();
        runs.push_back(std::move(run));
    };
    for (std::size_t k = 0; k < content.report.error_traces.size(); ++k) {
        const ModelErrorTrace& each = content.report.error_traces[k];
        add({"breakdown-" + std::to_string(k + 1), "breakdown", "model error: " + each.code, each.message, "",
             &each.trace, all});
    }
    if (content.faults)
        for (Playable& run : fault_runs(content, all)) add(std::move(run));
    if (content.tuning)
        for (Playable& run : tuning_runs(content, all)) add(std::move(run));
    if (content.recording)
        for (Playable& run : recording_runs(content)) add(std::move(run));
    for (const bool violated : {true, false})
        for (const PropertyResult& answer : content.report.answers) {
            const Verdict& verdict = answer.verdict;
            if (!answer.trace || (verdict.outcome == Outcome::Violated) != violated) continue;
            const std::string kind = violated ? "counterexample" : "witness";
            const std::string end = answer.trace->loop_from ? "" : std::string(end_of(verdict));
            add({verdict.property, kind, verdict.property + ": " + kind, end, verdict.property, &*answer.trace, all});
        }
    for (std::size_t k = 0; k < content.charts.size(); ++k)
        for (const Finding& finding : content.charts[k].analysis.findings)
            if (finding.evidence) {
                const std::string name = evidence_name(content, content.charts[k].analysis, finding);
                add({name, "evidence", name + ": evidence", finding.evidence_shows, "", &*finding.evidence, {k}});
            }
    for (std::size_t k = 0; k < content.tests.size(); ++k) {
        const std::string number = std::to_string(k + 1);
        add({"test-" + number, "test", "test sequence " + number, "end of the sequence", "", &content.tests[k], {0}});
    }
    return runs;
}

namespace {

/// Returns the index of `value` in `list`. If `list` does not contain `value`, adds it.
std::size_t add_once(Json value, Json& list) {
    const auto known = std::ranges::find(list, value);
    const auto index = static_cast<std::size_t>(known - list.begin());
    if (known == list.end()) list.push_back(std::move(value));
    return index;
}

/// Returns the index of the property of a run in `properties`. If the run has other values of constants than the page,
/// its property is first added to `properties`.
std::optional<std::size_t> add_property(const PageContent& content, const Playable& playable, Json& properties) {
    if (!content.loop.valid()) return {};
    const Model& model = model_of(content, playable);
    const ClosedLoop& loop = model.loops[content.loop];
    const auto found = std::ranges::find(loop.properties, playable.property, &Property::name);
    if (found == loop.properties.end()) return {};
    return add_once(property_json(model, loop, *found), properties);
}

/// Returns the indices of the charts of a run. A chart with other values of constants is added to `varied`, whose
/// charts follow the charts of the page.
Json chart_indices(const PageContent& content, const Playable& playable, Json& varied) {
    if (playable.model == nullptr) return playable.charts;
    Json indices = Json::array();
    for (const std::size_t place : playable.charts) {
        const ChartContent& drawn = content.charts[place];
        const Id<ClosedLoop::Controller> controller{static_cast<std::uint32_t>(place)};
        const Chart& chart = playable.model->charts[playable.model->loops[content.loop].controllers[controller].chart];
        Json one = drawn.program ? Json() : chart_entry(place, drawn, chart);
        const bool same = drawn.program || one == chart_entry(place, drawn, drawn_chart(content, drawn));
        indices.push_back(same ? place : content.charts.size() + add_once(std::move(one), varied));
    }
    return indices;
}

}  // namespace

std::string page_data(const PageContent& content) {
    Json properties = Json::array(), runs = Json::array(), varied = Json::array();
    AllScans programs;
    for (const ChartContent& each : content.charts)
        if (each.program) programs.emplace_back(ProgramScans(content.model.charts[each.chart], each.program->listing));
        else programs.emplace_back();
    std::size_t remaining = most_points;
    if (content.loop.valid()) {
        const ClosedLoop& loop = content.model.loops[content.loop];
        for (const Property& property : loop.properties)
            properties.push_back(property_json(content.model, loop, property));
    }
    for (const Playable& playable : playable_runs(content)) {
        const std::optional<std::size_t> property = add_property(content, playable, properties);
        ChartRun run = *playable.run;
        std::optional<SentenceViolation> violation = violation_in(content, playable);
        omit_observers(run, violation);
        runs.push_back({{"name", playable.name},
                        {"kind", playable.kind},
                        {"title", playable.title},
                        {"property", property ? Json(*property) : Json(nullptr)},
                        {"charts", chart_indices(content, playable, varied)},
                        {"conditions", conditions_json(run)},
                        {"initial", initial_json(content, playable)},
                        {"end", playable.end},
                        {"violation", violation_json(violation)},
                        {"inside", inside_json(run, playable)},
                        {"loop_from", run.loop_from ? Json(*run.loop_from) : Json(nullptr)},
                        {"rows", rows_json(run)},
                        {"scans", scans_json(run, playable, programs, remaining)},
                        {"run", run_json(run)}});
    }
    Json charts = charts_json(content, programs);
    charts.insert(charts.end(), varied.begin(), varied.end());
    const std::string text = json_text({{"version", 1},
                                        {"charts", std::move(charts)},
                                        {"properties", std::move(properties)},
                                        {"plant", plant_json(content)},
                                        {"runs", std::move(runs)}},
                                       -1);
    std::string safe;
    safe.reserve(text.size());
    for (const char c : text) {
        if (c == '<') safe += "\\u003c";
        else safe += c;
    }
    return safe;
}

}  // namespace grafverif
