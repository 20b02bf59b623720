// SPDX-License-Identifier: MIT
// Adds the results of a fault analysis to a page: the minimal combinations of faults that violate each property, and
// the effects of each fault (FMEA).
#include "report/charts/faults.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "page/data.hpp"
#include "page/parts.hpp"
#include "page/words.hpp"
#include "report/terminal.hpp"

namespace grafverif {

namespace {

/// For each property: maximum number of undecided combinations that are listed, and of non-monotone combinations that
/// are listed.
constexpr std::size_t most_listed = 50;

std::string run_name(const FaultAnalysis& analysis, const FaultAnalysis::Row& row, const FaultAnalysis::Cut& cut) {
    return row.property + ": " + names_of(analysis, cut.faults);
}

std::string error_run_name(std::size_t index) { return "model error " + std::to_string(index + 1); }

/// Returns the initial locations of the instances whose faults are present from power-on. In the model with a fault,
/// the locations of the fault follow the locations of the instance (pipeline/variants/fault_model.hpp).
std::map<std::string, std::optional<std::size_t>> initial_locations(const PageContent& content,
                                                                    const FaultSet& from_power_on) {
    const ClosedLoop& loop = content.model.loops[content.loop];
    std::map<std::string, std::optional<std::size_t>> initial;
    for (const std::size_t index : from_power_on) {
        const ClosedLoop::Fault& fault = loop.faults[{static_cast<std::uint32_t>(index)}];
        const ClosedLoop::Instance& instance = loop.instances[fault.of];
        initial[instance.name] =
            content.model.components[instance.component].locations.size() + fault.behaviour.initial.index;
    }
    return initial;
}

PropertyLook look_of(const FaultAnalysis::Row& row) {
    if (row.without_faults == Outcome::Violated) return {row.expected_violated ? "expected" : "bad", "✗"};
    if (row.without_faults == Outcome::Unknown) return {"unknown", "?"};
    if (!row.minimal.empty()) return {"bad", "✗"};
    return row.open.empty() ? PropertyLook{"ok", "✓"} : PropertyLook{"unknown", "?"};
}

std::string outcome_text(const FaultAnalysis& analysis, const FaultAnalysis::Row& row) {
    if (row.without_faults != Outcome::Holds)
        return fmt::format("{} without faults{}", word(row.without_faults),
                           row.without_faults == Outcome::Violated && row.expected_violated ? ", as expected" : "");
    std::string text;
    if (!row.minimal.empty())
        text = fmt::format("violated with {}", counted(row.minimal.size(), "combination", "combinations"));
    if (!row.open.empty())
        text += fmt::format("{}unknown for {}", text.empty() ? "" : ", ",
                            counted(row.open.size(), "combination", "combinations"));
    return text.empty() ? "holds for all combinations of at most " + counted(analysis.order, "fault", "faults") : text;
}

void add_cut(const FaultAnalysis& analysis, const FaultAnalysis::Row& row, const FaultAnalysis::Cut& cut, Html& html) {
    const std::string names = names_of(analysis, cut.faults);
    html.open("li");
    if (cut.result.trace && can_be_played(*cut.result.trace))
        html.put("button", "▶ " + names,
                 {{"type", "button"},
                  {"class", "play"},
                  {"data-run", run_name(analysis, row, cut)},
                  {"data-name", names},
                  {"title", "Play a run that violates the property"}});
    else html.put("strong", names);
    std::string remark;
    if (cut.from_power_on == cut.faults) remark += " present from power-on;";
    else if (!cut.from_power_on.empty())
        remark += " present from power-on: " + names_of(analysis, cut.from_power_on) + ";";
    if (!cut.result.trace) remark += " " + absence_of_trace(row, cut) + ";";
    else if (!can_be_played(*cut.result.trace))
        remark +=
            fmt::format(" the run has {} steps, which is too many for the player;", cut.result.trace->moments.size());
    if (const std::string note = unproved(analysis, cut); !note.empty()) remark += " " + note + ";";
    if (!remark.empty()) html.put("span", remark.substr(0, remark.size() - 1), {{"class", "remark"}});
    html.close("li");
}

/// Adds a list with at most the first `most_listed` elements of `lines`.
void add_list(std::string_view title, const std::vector<std::string>& lines, Html& html) {
    if (lines.empty()) return;
    html.put("p", title).open("ul");
    for (std::size_t k = 0; k < std::min(lines.size(), most_listed); ++k) html.open("li").prose(lines[k]).close("li");
    if (lines.size() > most_listed)
        html.put("li", fmt::format("and {} further combinations", lines.size() - most_listed));
    html.close("ul");
}

void add_row(const PageContent& content, const FaultAnalysis::Row& row, Html& html) {
    const FaultAnalysis& analysis = *content.faults;
    const PropertyLook look = look_of(row);
    begin_property(look, row.property, row.text, outcome_text(analysis, row), look.kind == std::string_view("ok"),
                   html);
    add_formula(content, content.loop, row.property, html);
    if (!row.declared && row.without_faults != Outcome::Unknown)
        html.put("p", "This property is always checked, even if the model does not declare it or it is not selected.");
    if (row.without_faults != Outcome::Holds)
        html.put("p", "The analysis considers only properties that hold without faults.");
    if (!row.minimal.empty()) {
        html.put("p", "Minimal combinations of faults that lead to a violation:").open("ul", {{"class", "cuts"}});
        for (const FaultAnalysis::Cut& cut : row.minimal) add_cut(analysis, row, cut, html);
        html.close("ul");
    }
    std::vector<std::string> open, restored;
    for (const FaultAnalysis::Open& each : row.open)
        open.push_back(names_of(analysis, each.faults) + (each.reason.empty() ? "" : ": " + each.reason));
    for (const FaultAnalysis::NonMonotone& each : row.non_monotone)
        restored.push_back(names_of(analysis, each.violating) + " leads to a violation, " +
                           names_of(analysis, each.holding) + " does not");
    add_list("Unknown for these combinations:", open, html);
    add_list("Further faults can restore the property:", restored, html);
    html.close("details");
}

void add_effects(const FaultAnalysis& analysis, Html& html) {
    html.put("h3", "Effects of each fault (FMEA)").open("div", {{"class", "wide"}}).open("table", {{"class", "fmea"}});
    html.open("thead").open("tr");
    for (const char* const title : {"fault", "instance", "behaves as", "properties", "steps and outputs"})
        html.put("th", title, {{"scope", "col"}});
    html.close("tr").close("thead").open("tbody");
    for (std::size_t k = 0; k < analysis.faults.size(); ++k) {
        const FaultAnalysis::Fault& fault = analysis.faults[k];
        const FaultEffects effects = effects_of(analysis, k);
        html.open("tr").put("th", fault.name, {{"scope", "row"}});
        html.put("td", fault.instance).put("td", fault.component);
        for (const auto* const sentences : {&effects.on_properties, &effects.visible}) {
            html.open("td");
            for (const std::string& sentence : *sentences) html.put("div", sentence);
            html.close("td");
        }
        html.close("tr");
    }
    html.close("tbody").close("table").close("div");
}

}  // namespace

SummaryItem summary_of(const FaultAnalysis& analysis) {
    if (!analysis.failures.empty())
        return {"bad", "Internal error: the results fail an internal check, such as the replay of a trace."};
    if (!analysis.errors.empty()) return {"bad", "Model error."};
    std::size_t wrong = 0, violated = 0, open = 0;
    for (const FaultAnalysis::Row& row : analysis.rows) {
        if (row.without_faults == Outcome::Violated && !row.expected_violated) ++wrong;
        if (!row.minimal.empty()) ++violated;
        if (row.without_faults == Outcome::Unknown || !row.open.empty()) ++open;
    }
    std::string words;
    const auto add = [&](std::size_t count, std::string_view what) {
        if (count != 0)
            words +=
                (words.empty() ? "" : "; ") + counted(count, "property is", "properties are") + " " + std::string(what);
    };
    const std::string most = "at most " + counted(analysis.order, "fault", "faults");
    add(wrong, "violated without faults");
    add(violated, "violated with combinations of " + most);
    add(open, "unknown for some combinations");
    if (!words.empty()) return {wrong + violated != 0 ? "bad" : "unknown", words + "."};
    return {"ok", "No combination of " + most + " leads to a violation of a property that holds without faults."};
}

std::vector<Playable> fault_runs(const PageContent& content, const std::vector<std::size_t>& charts) {
    std::vector<Playable> runs;
    const FaultAnalysis& analysis = *content.faults;
    for (std::size_t k = 0; k < analysis.errors.size(); ++k) {
        const FaultAnalysis::Error& error = analysis.errors[k];
        Playable run{error_run_name(k),
                     "breakdown",
                     fmt::format("model error with {}: {}", names_of(analysis, error.faults), error.trace.code),
                     error.trace.message,
                     "",
                     &error.trace.trace,
                     charts};
        // For an error, the analysis does not state which faults are present from power-on; the initial locations are
        // therefore unknown.
        for (auto& [instance, location] : run.initial = initial_locations(content, error.faults)) location.reset();
        runs.push_back(std::move(run));
    }
    for (const FaultAnalysis::Row& row : analysis.rows)
        for (const FaultAnalysis::Cut& cut : row.minimal) {
            if (!cut.result.trace) continue;
            const ChartRun& run = *cut.result.trace;
            const std::string end = run.loop_from ? "" : std::string(end_of(cut.result.verdict));
            const std::string name = run_name(analysis, row, cut);
            runs.push_back({name, "counterexample", name, end, row.property, &run, charts,
                            initial_locations(content, cut.from_power_on)});
        }
    return runs;
}

void add_faults(const PageContent& content, Html& html) {
    const FaultAnalysis& analysis = *content.faults;
    html.open("section", {{"id", "faults"}}).put("h2", "Faults");
    html.open("p", {{"class", "remark"}})
        .prose(fmt::format("{}, {} of at most {}, {}. A property must hold if each fault of a combination occurs at "
                           "power-on, at any later time, or never. For `reachable`, all faults of the combination are "
                           "present from power-on. Two faults of one instance are not combined.",
                           counted(analysis.faults.size(), "fault", "faults"),
                           counted(analysis.combinations, "combination", "combinations"), analysis.order,
                           counted(analysis.checks, "check", "checks")))
        .close("p");
    for (const FaultAnalysis::Row& row : analysis.rows)
        if (is_shown(row)) add_row(content, row, html);
    for (std::size_t k = 0; k < analysis.errors.size(); ++k) {
        const FaultAnalysis::Error& error = analysis.errors[k];
        html.open("p", {{"class", "bad"}})
            .text(fmt::format("Model error with {}: {} [{}] ", names_of(analysis, error.faults), error.trace.message,
                              error.trace.code));
        if (can_be_played(error.trace.trace))
            html.put("button", "▶ Play the run",
                     {{"type", "button"}, {"class", "play"}, {"data-run", error_run_name(k)}});
        html.close("p");
    }
    for (const std::string& failure : analysis.failures) html.put("p", failure, {{"class", "bad"}});
    add_effects(analysis, html);
    html.close("section");
}

}  // namespace grafverif
