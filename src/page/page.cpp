// SPDX-License-Identifier: MIT
#include "page/page.hpp"

#include <algorithm>

#include "page/data.hpp"
#include "page/html.hpp"
#include "page/parts.hpp"
#include "page/scans.hpp"
#include "page/web.hpp"

namespace grafverif {

namespace {

/// Returns the content security policy of the page, which permits only the style and the script of the page itself, and
/// pictures that the script creates.
std::string policy() {
    return "default-src 'none'; script-src 'sha256-" + std::string(page_script().sha256) + "'; style-src 'sha256-" +
           std::string(page_style().sha256) + "'; img-src data:; base-uri 'none'; form-action 'none'";
}

void add_contents(const PageContent& content, Html& html) {
    html.open("nav", {{"aria-label", "Sections"}}).open("ul");
    const auto add = [&html](const char* id, const char* title) {
        html.open("li").put("a", title, {{"href", std::string("#") + id}}).close("li");
    };
    const bool complete = is_about_verdicts(content);
    if (content.faults) add("faults", "Faults");
    else if (content.tuning) add("tuning", "Values of constants");
    else if (content.recording) add("recording", "Recording");
    else add("verdicts", "Properties");
    if (!playable_runs(content).empty()) add("runs", "Runs");
    add("charts", charts_title(content));
    if (complete && has_charts(content)) add("findings", "Findings");
    if (content.loop.valid()) add("plant", "Plant");
    if (complete && has_charts(content)) add("equations", "Equations");
    if (complete && has_steps(content)) add("coverage", "Coverage");
    html.close("ul").close("nav");
}

/// Adds to the runs of the content the transitions that each scan of a program clears.
void add_cleared_transitions(PageContent& content) {
    const auto add = [&](ChartRun& run) {
        for (std::size_t k = 0; k < content.charts.size() && k < run.controllers.size(); ++k)
            if (content.charts[k].program)
                add_cleared_transitions(run, {static_cast<std::uint32_t>(k)}, content.charts[k].program->drawn);
    };
    for (PropertyResult& answer : content.report.answers)
        if (answer.trace) add(*answer.trace);
    for (ModelErrorTrace& each : content.report.error_traces) add(each.trace);
    if (content.faults) {
        for (FaultAnalysis::Error& each : content.faults->errors) add(each.trace.trace);
        for (FaultAnalysis::Row& row : content.faults->rows)
            for (FaultAnalysis::Cut& cut : row.minimal)
                if (cut.result.trace) add(*cut.result.trace);
    }
    if (content.tuning)
        for (Tuning::Row& row : content.tuning->rows)
            for (auto& [_, result] : row.runs)
                if (result.trace) add(*result.trace);
}

std::string written(const PageContent& content) {
    Html html;
    html.trusted("<!DOCTYPE html>\n").open("html", {{"lang", "en"}}).open("head");
    html.open("meta", {{"charset", "utf-8"}})
        .open("meta", {{"http-equiv", "Content-Security-Policy"}, {"content", policy()}})
        .open("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}})
        .open("meta", {{"name", "color-scheme"}, {"content", "light dark"}})
        .open("meta", {{"name", "generator"}, {"content", "grafverif " + content.version}});
    html.put("title", content.report.model + " - grafverif");
    html.trusted("<style>").trusted(page_style().text).trusted("</style>\n").close("head");
    html.open("body");
    add_head(content, html);
    add_contents(content, html);
    html.open("main");
    const bool complete = is_about_verdicts(content);
    if (content.faults) add_faults(content, html);
    else if (content.tuning) add_tuning(content, html);
    else if (content.recording) add_recording(content, html);
    else add_verdicts(content, html);
    add_runs(content, html);
    add_charts(content, html);
    if (complete && has_charts(content)) add_findings(content, html);
    add_plant(content, html);
    if (complete && has_charts(content)) add_equations(content, html);
    if (complete && has_steps(content)) add_coverage(content, html);
    html.close("main");
    html.open("script", {{"type", "application/json"}, {"id", "data"}}).trusted(page_data(content)).close("script");
    html.open("script", {{"type", "module"}}).trusted(page_script().text).close("script");
    html.close("body").close("html");
    return html.str();
}

}  // namespace

std::string page_of(const PageContent& content) {
    if (std::ranges::none_of(content.charts, [](const ChartContent& each) { return each.program.has_value(); }))
        return written(content);
    PageContent complete = content;
    add_cleared_transitions(complete);
    return written(complete);
}

}  // namespace grafverif
