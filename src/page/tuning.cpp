// SPDX-License-Identifier: MIT
// Adds the results of tuning to a page: for each property, a map of the grid (one or two constants) or a table of
// boxes, and the margins of the current values.
#include "report/charts/tuning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "page/data.hpp"
#include "page/parts.hpp"
#include "page/words.hpp"
#include "report/terminal.hpp"

namespace grafverif {

namespace {

using Row = Tuning::Row;

/// True if the drawings of the page also represent `model`, the model at a point of the grid: both models have the same
/// controllers, with the same elements in their charts, and instances with equal names have the same component.
bool has_drawn_elements(const PageContent& content, const Model& model) {
    const ClosedLoop &drawn = content.model.loops[content.loop], &loop = model.loops[content.loop];
    if (loop.controllers.size() != content.charts.size()) return false;
    for (const Id<ClosedLoop::Controller> id : loop.controllers.ids()) {
        const ChartContent& one = content.charts[id.index];
        const Chart& chart = model.charts[loop.controllers[id].chart];
        if (chart.name != content.model.charts[one.chart].name ||
            static_cast<bool>(chart.program) != one.program.has_value())
            return false;
        if (!one.program && element_ids(chart, one.prefix) != element_ids(drawn_chart(content, one), one.prefix))
            return false;
    }
    return std::ranges::all_of(loop.instances, [&](const ClosedLoop::Instance& instance) {
        const auto same = std::ranges::find(drawn.instances, instance.name, &ClosedLoop::Instance::name);
        return same == drawn.instances.end() ||
               content.model.components[same->component].name == model.components[instance.component].name;
    });
}

std::string run_name(const Tuning& tuning, const Row& row, std::size_t point) {
    return row.property + ": " + point_text(tuning, point);
}

bool is_unexpected(const Row& row) {
    return std::ranges::any_of(row.verdicts, [&](const PointVerdict& each) {
        return each.outcome != Outcome::Unknown && each.outcome != row.expected();
    });
}

bool is_unknown(const Row& row) {
    return std::ranges::any_of(row.verdicts, [](const PointVerdict& each) { return each.outcome == Outcome::Unknown; });
}

PropertyLook look_of(const Row& row) {
    if (is_unexpected(row)) return {"bad", "✗"};
    if (is_unknown(row)) return {"unknown", "?"};
    return row.expected_violated ? PropertyLook{"expected", "✗"} : PropertyLook{"ok", "✓"};
}

std::string outcome_text(const Tuning& tuning, const Row& row) {
    std::vector<std::string> words;
    for (const Outcome outcome : {Outcome::Holds, Outcome::Violated, Outcome::Unknown})
        if (const auto count = std::ranges::count(row.verdicts, outcome, &PointVerdict::outcome); count != 0)
            words.push_back(fmt::format("{} at {}", word(outcome), count));
    return listed(words) + " of " + counted(tuning.points, "point", "points");
}

/// Adds the table cell of a grid point. If the property is violated at the point and the page contains the run, the
/// cell is a button.
void add_cell(const Tuning& tuning, const Row& row, std::size_t point, bool current, const std::set<std::string>& runs,
              Html& html) {
    const PointVerdict& verdict = row.verdicts[point];
    const char* const mark = verdict.outcome == Outcome::Holds ? "✓" : verdict.outcome == Outcome::Violated ? "✗" : "?";
    const std::string about = point_text(tuning, point) + ": " + std::string(word(verdict.outcome));
    Html::Attributes attributes = {{"class", std::string(word(verdict.outcome)) + (current ? " current" : "")},
                                   {"title", current ? about + " (current values)" : about}};
    if (current) attributes.emplace_back("aria-current", "true");
    html.open("td", attributes);
    const std::string run = row.runs.contains(point) ? run_name(tuning, row, point) : std::string();
    if (runs.contains(run))
        html.put("button", mark,
                 {{"type", "button"}, {"class", "link"}, {"data-run", run}, {"aria-label", "Play the run: " + about}});
    else html.text(mark);
    html.close("td");
}

bool has_map(const Tuning& tuning) {
    const std::vector<TunedConstant>& constants = tuning.constants;
    return constants.size() <= 2 && constants.back().size() <= widest_map &&
           (constants.size() == 1 || constants.front().size() <= tallest_map);
}

/// Adds the map of a property. The values of the last constant are the columns; if there are two constants, the values
/// of the first constant are the rows.
void add_map(const Tuning& tuning, const Row& row, const std::set<std::string>& runs, Html& html) {
    const TunedConstant& across = tuning.constants.back();
    const bool two = tuning.constants.size() == 2;
    const std::size_t lines = two ? tuning.constants[0].size() : 1;
    const auto here = across.current_index();
    html.open("div", {{"class", "wide"}}).open("table", {{"class", "map"}});
    html.open("thead").open("tr").put("th", two ? tuning.constants[0].name + " ↓  " + across.name + " →" : across.name);
    for (std::size_t k = 0; k < across.size(); ++k)
        html.put("th", value_text(across, across.value(k)), {{"scope", "col"}});
    html.close("tr").close("thead").open("tbody");
    for (std::size_t line = 0; line < lines; ++line) {
        const TunedConstant& down = tuning.constants[0];
        html.open("tr").put("th", two ? value_text(down, down.value(line)) : "verdict", {{"scope", "row"}});
        const bool is_line = !two || down.current_index() == line;
        for (std::size_t k = 0; k < across.size(); ++k)
            add_cell(tuning, row, two ? tuning.point({line, k}) : k, is_line && here == k, runs, html);
        html.close("tr");
    }
    html.close("tbody").close("table").close("div");
}

void add_boxes(const Tuning& tuning, const Row& row, Html& html) {
    html.open("div", {{"class", "wide"}}).open("table").open("thead").open("tr");
    for (const TunedConstant& constant : tuning.constants) html.put("th", constant.name, {{"scope", "col"}});
    html.put("th", "verdict", {{"scope", "col"}}).close("tr").close("thead").open("tbody");
    for (const GridBox& box : boxes_of(tuning, row)) {
        html.open("tr");
        for (std::size_t k = 0; k < tuning.constants.size(); ++k)
            html.put("td", range_text(tuning.constants[k], box.first[k], box.last[k]));
        html.put("td", verdict_text(tuning, row.verdicts[tuning.point(box.first)])).close("tr");
    }
    html.close("tbody").close("table").close("div");
}

void add_margins(const Tuning& tuning, const Row& row, Html& html) {
    const std::vector<std::string> sentences = margin_sentences(tuning, row);
    const bool on_grid = std::ranges::all_of(
        tuning.constants, [](const TunedConstant& each) { return each.current_index().has_value(); });
    if (row.current.outcome == Outcome::Unknown)
        return void(html.put("p", "Verdict with the current values: " + verdict_text(tuning, row.current) + "."));
    if (sentences.empty() && on_grid)
        html.put("p", fmt::format("Verdict with the current values: {}. On the grid, a change of a single constant "
                                  "does not change this verdict.",
                                  word(row.current.outcome)));
    if (sentences.empty() && !on_grid)
        html.put("p", fmt::format("Verdict with the current values: {}. These values are not a point of the grid.",
                                  word(row.current.outcome)));
    if (sentences.empty()) return;
    html.put("p", fmt::format("Verdict with the current values: {}. Margins:", word(row.current.outcome)))
        .open("ul", {{"class", "margins"}});
    for (const std::string& sentence : sentences) html.put("li", sentence);
    html.close("ul");
}

/// Adds buttons for the runs of a property without a map.
void add_run_buttons(const Tuning& tuning, const Row& row, const std::set<std::string>& runs, Html& html) {
    for (const auto& [point, _] : row.runs)
        if (const std::string name = run_name(tuning, row, point); runs.contains(name))
            html.put("button", "▶ " + point_text(tuning, point),
                     {{"type", "button"}, {"class", "play"}, {"data-run", name}});
}

void add_row(const PageContent& content, const Row& row, const std::set<std::string>& runs, Html& html) {
    const Tuning& tuning = *content.tuning;
    const PropertyLook look = look_of(row);
    begin_property(look, row.property, row.text, outcome_text(tuning, row), look.kind == std::string_view("ok"), html);
    add_formula(content, content.loop, row.property, html);
    add_margins(tuning, row, html);
    const bool map = has_map(tuning);
    if (!is_uniform(row) || is_unknown(row) || !row.runs.empty()) {
        if (map) add_map(tuning, row, runs, html);
        if (!map || is_unknown(row)) add_boxes(tuning, row, html);
        if (!map) add_run_buttons(tuning, row, runs, html);
    }
    html.close("details");
}

}  // namespace

SummaryItem summary_of(const Tuning& tuning) {
    if (!tuning.failures.empty())
        return {"bad", "Internal error: the results fail an internal check, such as the replay of a trace."};
    const auto unexpected = static_cast<std::size_t>(std::ranges::count_if(tuning.rows, is_unexpected));
    const auto open = static_cast<std::size_t>(std::ranges::count_if(tuning.rows, is_unknown));
    std::vector<std::string> words;
    if (tuning.model_error) words.emplace_back("a model error occurs at some grid point");
    if (unexpected != 0)
        words.push_back(counted(unexpected, "property has", "properties have") +
                        " an unexpected verdict at some grid point");
    if (open != 0) words.push_back(counted(open, "property is", "properties are") + " unknown at some grid point");
    if (words.empty() && std::ranges::none_of(tuning.rows, &Row::declared))
        return {"unknown", "There are no properties."};
    if (words.empty())
        return {"ok", fmt::format("Each property has its expected verdict at {}.",
                                  tuning.points == 1 ? "the point" : fmt::format("all {} points", tuning.points))};
    std::string text;
    for (const std::string& each : words) text += (text.empty() ? "" : "; ") + each;
    text[0] = text[0] == 'a' ? 'A' : text[0];
    return {tuning.model_error || unexpected != 0 ? "bad" : "unknown", text + "."};
}

std::vector<Playable> tuning_runs(const PageContent& content, const std::vector<std::size_t>& charts) {
    std::vector<Playable> runs;
    for (const Row& row : content.tuning->rows)
        for (const auto& [point, result] : row.runs) {
            const auto model = content.point_models.find(point);
            if (!result.trace || model == content.point_models.end()) continue;
            if (!has_drawn_elements(content, model->second)) continue;
            const std::string end = result.trace->loop_from ? "" : std::string(end_of(result.verdict));
            const std::string name = run_name(*content.tuning, row, point);
            Playable run{name, "counterexample", name, end, row.property, &*result.trace, charts};
            run.model = &model->second;
            runs.push_back(std::move(run));
        }
    return runs;
}

void add_tuning(const PageContent& content, Html& html) {
    const Tuning& tuning = *content.tuning;
    html.open("section", {{"id", "tuning"}}).put("h2", "Values of constants").open("ul");
    for (const TunedConstant& constant : tuning.constants) html.put("li", grid_text(constant));
    html.close("ul");
    html.open("p", {{"class", "remark"}})
        .prose(fmt::format("{}, {} checked. The verdict at a point is that of `check` with the values of the point. "
                           "Drawings, formulas and the plant show the current values; the title of a run shows the "
                           "values of the run.",
                           counted(tuning.points, "point", "points"), counted(tuning.checks, "model", "models")))
        .close("p");
    if (has_map(tuning))
        html.put("p",
                 "✓ holds, ✗ violated, ? unknown; the cell with the current values has a frame. Click on an underlined "
                 "✗ to play a run that violates the property with the values of the cell.",
                 {{"class", "remark"}});
    if (std::ranges::any_of(content.point_models,
                            [&](const auto& each) { return !has_drawn_elements(content, each.second); }))
        html.put("p",
                 "At some points, the closed loop has other controllers, steps, transitions or components than the "
                 "drawings show. The page does not contain the runs at these points.",
                 {{"class", "remark"}});
    std::set<std::string> runs;
    for (const Playable& run : playable_runs(content)) runs.insert(run.name);
    for (const Row& row : tuning.rows)
        if (is_shown(tuning, row) || is_unknown(row)) add_row(content, row, runs, html);
    for (const std::string& failure : tuning.failures) html.put("p", failure, {{"class", "bad"}});
    html.close("section");
}

}  // namespace grafverif
