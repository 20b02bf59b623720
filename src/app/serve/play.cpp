// SPDX-License-Identifier: MIT
#include "app/serve/play.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/serve/request_json.hpp"
#include "grafverif/ir/drawing.hpp"
#include "ir/program/interface.hpp"
#include "page/terms.hpp"
#include "pipeline/chart_text.hpp"
#include "pipeline/models.hpp"
#include "report/table.hpp"
#include "simulate/simulation.hpp"
#include "support/json_text.hpp"
#include "support/overloaded.hpp"
#include "support/printable.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif::app {

namespace {

using Json = nlohmann::ordered_json;

/// A simulation request, as sent by a page.
struct PlayRequest {
    std::string loop = {}, chart = {};  ///< exactly one of `loop` and `chart` is not empty
    std::vector<std::string> moves = {};
    std::uint64_t seed = 0, random = 0;  ///< seed and number of the random moves after `moves`
    bool everything = false;             ///< for a loop: each edge is a separate choice
};

Json error_text(const std::string& words) { return {{"error", printable(words)}}; }

std::optional<PlayRequest> parse_request(const std::string& request) {
    const Json json = shallow_json(request, 4);
    if (!json.is_object()) return {};
    PlayRequest parsed;
    const auto text = [&](const char* key, std::string& into) {
        if (json.contains(key) && json[key].is_string()) into = json[key].get<std::string>();
    };
    const auto number = [&](const char* key, std::uint64_t& into) {
        if (json.contains(key) && json[key].is_number_unsigned()) into = json[key].get<std::uint64_t>();
    };
    text("loop", parsed.loop);
    text("chart", parsed.chart);
    number("seed", parsed.seed);
    number("random", parsed.random);
    parsed.everything = json.contains("everything") && json["everything"] == true;
    if (!json.contains("moves")) return parsed;
    if (!json["moves"].is_array()) return {};
    for (const Json& move : json["moves"]) {
        if (!move.is_string()) return {};
        parsed.moves.push_back(move.get<std::string>());
    }
    return parsed;
}

/// Returns the script line that is equivalent to a randomly chosen command.
std::string line_of(const Command& command, const Simulation& simulation) {
    if (const auto* const wait = std::get_if<WaitCommand>(&command))
        return "wait " + duration_text(*wait->milliseconds);
    return simulation.choices()[std::get<ChooseCommand>(command).number - 1].command;
}

/// Executes the moves sequentially and records the state after each move.
class MovePlayer {
public:
    /// `writers` maps, for a loop, each shared variable to `environment` or `plant`.
    MovePlayer(Simulation& simulation, std::vector<ElementIds> ids, std::map<std::string, std::string> writers)
        : simulation_(simulation), ids_(std::move(ids)), writers_(std::move(writers)) {}

    Json play(const PlayRequest& parsed) {
        problem_ = simulation_.begin();
        ends_.push_back(rows());
        for (const std::string& move : parsed.moves)
            if (problem_.empty()) make(move);
        RandomWalk walk(parsed.seed);
        for (std::uint64_t k = 0; k < parsed.random && problem_.empty(); ++k) {
            const std::optional<Command> next = walk.draw(simulation_);
            if (!next) break;
            make(line_of(*next, simulation_));
        }
        return answer();
    }

private:
    std::size_t rows() const { return simulation_.recorded_run().rows.size(); }

    void make(const std::string& move) {
        const Command command = command_of(move);
        const bool moves = std::holds_alternative<SetCommand>(command) ||
                           std::holds_alternative<WaitCommand>(command) || std::holds_alternative<DoCommand>(command) ||
                           std::holds_alternative<ChooseCommand>(command) ||
                           std::holds_alternative<ForceCommand>(command);
        problem_ = moves || std::holds_alternative<BadCommand>(command) ? simulation_.execute(command)
                                                                        : "`" + move + "` is not a valid move";
        made_.push_back(move);
        ends_.push_back(rows());
    }

    /// Returns the ids of the active steps in the drawings of the charts.
    Json lit(const ChartRun::State& state) const {
        const ChartRun& run = simulation_.recorded_run();
        Json list = Json::array();
        for (const Id<ChartRun::Controller> id : run.controllers.ids()) {
            const ChartRun::Controller& controller = run.controllers[id];
            for (std::size_t k = 0; k < controller.steps.size(); ++k)
                if (std::ranges::binary_search(state.situation, controller.steps[k]))
                    list.push_back(ids_[id.index].steps[k]);
        }
        return list;
    }

    Json cleared(const ChartRun::Row& row) const {
        const ChartRun& run = simulation_.recorded_run();
        Json list = Json::array();
        for (const Id<ChartRun::Controller> id : run.controllers.ids()) {
            const auto& transitions = run.controllers[id].transitions;
            for (std::size_t k = 0; k < transitions.size(); ++k)
                for (const auto& evolution : row.fired)
                    if (std::ranges::find(evolution, transitions[k]) != evolution.end())
                        list.push_back(ids_[id.index].transitions[k]);
        }
        return list;
    }

    /// Returns the last rows of the run, at most as many as a page shows. Each row has the number of the move that
    /// caused it.
    Json rows_json() const {
        const ChartRun& run = simulation_.recorded_run();
        Json list = Json::array();
        for (std::size_t k = run.rows.size() - std::min(run.rows.size(), most_rows); k < run.rows.size(); ++k) {
            if (!is_shown(run, k)) continue;
            const ChartRun::State& after = run.after(run.rows[k]);
            const Cells words = cells(run, k, true);
            list.push_back({{"move", std::ranges::upper_bound(ends_, k) - ends_.begin()},
                            {"time", event_text(run, after)},
                            {"kind", word(run.rows[k].kind)},
                            {"trial", simulation_.what_if_row().value_or(k + 1) <= k},
                            {"what", words[1]},
                            {"inputs", words[2]},
                            {"cleared", words[3]},
                            {"situation", words[4]},
                            {"outputs", words[5]},
                            {"lit", lit(after)},
                            {"fired", cleared(run.rows[k])}});
        }
        return list;
    }

    Json steps_json() const {
        const ChartRun& run = simulation_.recorded_run();
        const auto& now = run.moments.back().after.situation;
        Json list = Json::array();
        for (const Id<ChartRun::Step> id : run.steps.ids())
            list.push_back({{"name", run.steps[id].short_name}, {"active", std::ranges::binary_search(now, id)}});
        return list;
    }

    Json signals_json() const {
        const ChartRun& run = simulation_.recorded_run();
        const ChartRun::State& now = run.moments.back().after;
        Json list = Json::array();
        for (const Id<ChartRun::Signal> id : run.signals.ids()) {
            const ChartRun::Signal& signal = run.signals[id];
            const std::int64_t value = now.values[id.index];
            if (signal.role == ChartRun::Role::Image) continue;
            list.push_back({{"name", signal.name},
                            {"role", word(signal.role)},
                            {"by", writers_.contains(signal.name) ? Json(writers_.at(signal.name)) : Json(nullptr)},
                            {"value", signal.type.boolean ? Json(value != 0) : Json(value)},
                            {"low", signal.type.low},
                            {"high", signal.type.high}});
        }
        return list;
    }

    Json answer() const {
        const DelayBounds delay_bounds = simulation_.delay_bounds();
        const auto milliseconds = [&](const std::optional<std::int64_t>& units) {
            return units ? Json(*units * delay_bounds.unit_ms) : Json(nullptr);
        };
        Json choices = Json::array();
        for (const Choice& choice : simulation_.choices())
            choices.push_back({{"words", choice.words}, {"command", choice.command}});
        return {{"moves", made_},
                {"problem", printable(problem_)},
                {"time", simulation_.recorded_run().moments.back().after.time_ms},
                {"rows", rows_json()},
                {"trial", simulation_.what_if_row().has_value()},
                {"signals", signals_json()},
                {"steps", steps_json()},
                {"choices", std::move(choices)},
                {"wait",
                 {{"may", delay_bounds.may_pass},
                  {"unit", delay_bounds.unit_ms},
                  {"limit", milliseconds(delay_bounds.limit)},
                  {"change", milliseconds(delay_bounds.change)}}},
                {"broken_constraints", simulation_.violated_constraints()}};
    }

    Simulation& simulation_;
    std::vector<ElementIds> ids_;
    std::map<std::string, std::string> writers_;
    std::vector<std::string> made_ = {};
    std::vector<std::size_t> ends_ = {};  ///< number of rows after power-on and after each move
    std::string problem_ = {};
};

/// Returns, for each shared variable that an instance writes, the type of the instance: `environment` or `plant`.
std::map<std::string, std::string> writers_of(const Model& model, const ClosedLoop& loop) {
    std::map<std::string, std::string> writers;
    for (const ClosedLoop::Instance& instance : loop.instances) {
        const Component& component = model.components[instance.component];
        for (const Id<Component::Parameter> id : component.parameters.ids())
            if (const auto* shared = std::get_if<Id<ClosedLoop::Shared>>(&instance.arguments[id.index]);
                shared != nullptr && component.parameters[id].kind == Component::ParameterKind::Output)
                writers[loop.shared[*shared].name] = instance.environment ? "environment" : "plant";
    }
    return writers;
}

/// Returns data for highlighting a drawing: for each transition its ids and the steps that enable it, for each action
/// its step.
Json marks_of(const Chart& chart, const ElementIds& ids) {
    const Json known = chart_json(chart);
    Json transitions = Json::array(), actions = Json::array();
    for (std::size_t k = 0; k < ids.transitions.size(); ++k) {
        Json from = Json::array();
        for (const Json& step : known["transitions"][k]["from"]) from.push_back(ids.steps[step.get<std::size_t>()]);
        transitions.push_back({{"ids", {ids.transitions[k], ids.conditions[k]}}, {"from", std::move(from)}});
    }
    const auto add = [&](const std::vector<std::string>& list, const Json& owners) {
        for (std::size_t k = 0; k < list.size(); ++k)
            actions.push_back({{"id", list[k]}, {"step", ids.steps[owners[k].get<std::size_t>()]}});
    };
    add(ids.continuous, known["ownerOfAction"]);
    add(ids.forcing, known["ownerOfForcing"]);
    return {{"transitions", std::move(transitions)}, {"actions", std::move(actions)}};
}

Json played(const CheckedFile& piece, const Options& options, const PlayRequest& parsed) {
    if (!piece.reading.model) return error_text("the file has errors and cannot be simulated; correct them");
    const Model& model = *piece.reading.model;
    if (!parsed.loop.empty()) {
        const auto loop = find_loop(model, parsed.loop);
        if (!loop || !piece.networks[loop->index])
            return error_text("there is no closed loop `" + parsed.loop + "` that can be simulated");
        std::vector<ElementIds> ids;
        for (const ClosedLoop::Controller& controller : model.loops[*loop].controllers)
            ids.push_back(element_ids(model.charts[controller.chart], drawing_prefix(controller.chart)));
        Simulation simulation(*piece.networks[loop->index], charts_of(model, model.loops[*loop]),
                              parsed.everything ? Detail::Everything : Detail::Chart);
        return MovePlayer(simulation, std::move(ids), writers_of(model, model.loops[*loop])).play(parsed);
    }
    const auto chart = find_chart(model, parsed.chart);
    if (!chart || !piece.runs[chart->index])
        return error_text("there is no chart `" + parsed.chart + "` that can be simulated");
    Simulation simulation(model.charts[*chart], execution_mode(model, *chart, options.mode),
                          parsed.everything ? Detail::Everything : Detail::Chart);
    return MovePlayer(simulation, {element_ids(model.charts[*chart], drawing_prefix(*chart))}, {}).play(parsed);
}

}  // namespace

std::string drawing_prefix(Id<Chart> chart) { return "c" + std::to_string(chart.index) + "-"; }

std::string drawings(const CheckedFile& piece) {
    constexpr std::size_t most_steps = 5'000;  // larger drawings are not useful for a user
    Json list = Json::array(), marks = Json::array();
    if (piece.reading.model)
        for (const Id<Chart> id : piece.reading.model->charts.ids()) {
            const Chart& chart = piece.reading.model->charts[id];
            const bool is_drawn = chart.steps.size() <= most_steps && !(chart.program && chart.steps.empty());
            const DrawOptions options{.prefix = drawing_prefix(id)};
            const Chart drawn = chart.program && is_drawn ? drawn_chart(chart) : chart;
            marks.push_back(is_drawn ? marks_of(drawn, element_ids(drawn, options.prefix)) : Json(nullptr));
            list.push_back(is_drawn ? Json(svg_of(drawing_of(*piece.reading.model, id, options, piece.reading.sources)))
                                    : Json(nullptr));
        }
    return json_text({{"reading", piece.number}, {"drawings", std::move(list)}, {"marks", std::move(marks)}}, -1);
}

std::string play(const CheckedFile& piece, const Options& options, const std::string& request) {
    const std::optional<PlayRequest> parsed = parse_request(request);
    Json answer;
    if (!parsed)
        answer = error_text("malformed request; send an object with `loop` or `chart`, and `moves`, a list of strings");
    else if (parsed->moves.size() > most_moves || parsed->random > most_random_moves)
        answer = error_text("too many moves: at most " + std::to_string(most_moves) + " in total and " +
                            std::to_string(most_random_moves) + " random moves per request");
    else answer = played(piece, options, *parsed);
    return json_text(answer, -1);
}

}  // namespace grafverif::app
