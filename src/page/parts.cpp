// SPDX-License-Identifier: MIT
#include "page/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "page/data.hpp"
#include "page/terms.hpp"
#include "page/words.hpp"
#include "report/findings.hpp"
#include "report/report.hpp"
#include "report/settings_text.hpp"
#include "report/terminal.hpp"
#include "syntax/print/equations.hpp"

namespace grafverif {

namespace {

constexpr std::size_t longest_table = 400;  // maximum number of rows of a run that is also shown as text

void begin_section(Html& html, const char* id, std::string_view title) {
    html.open("section", {{"id", id}}).put("h2", title);
}

void add_play(Html& html, const ChartRun& trace, const std::string& run, std::string_view what) {
    if (!can_be_played(trace)) {
        html.put("p", fmt::format("The {} has {} steps, which is too many for the player; `check` and `analyse` with "
                                  "`--format json` print it.",
                                  what, trace.moments.size()));
        return;
    }
    html.put("button", fmt::format("▶ Play the {}", what), {{"type", "button"}, {"class", "play"}, {"data-run", run}});
}

// -- properties -------------------------------------------------------------------------------------------------------

std::string outcome_text(const Verdict& verdict) {
    std::string words(word(verdict.outcome));
    if (verdict.vacuous) words += ", vacuously";
    if (verdict.expected_violated && verdict.outcome != Outcome::Unknown)
        words += as_expected(verdict) ? ", as expected" : ", but expected to be violated";
    return words;
}

PropertyLook look_of(const Verdict& verdict) {
    if (verdict.outcome == Outcome::Unknown) return {"unknown", "?"};
    const char* const mark = verdict.outcome == Outcome::Holds ? "✓" : "✗";
    if (!as_expected(verdict)) return {"bad", mark};
    return {verdict.outcome == Outcome::Holds ? "ok" : "expected", mark};
}

void add_result(const PageContent& content, const PropertyResult& answer, Html& html) {
    const Verdict& verdict = answer.verdict;
    const bool folded = verdict.outcome == Outcome::Holds && as_expected(verdict) && !verdict.vacuous;
    std::string outcome = outcome_text(verdict);
    if (content.certificate)
        outcome += fmt::format(" (certificate: {})", certificate_word(*content.certificate, verdict.property));
    begin_property(look_of(verdict), verdict.property, answer.text, outcome, folded, html);
    add_formula(content, content.loop, verdict.property, html);
    if (!verdict.declared && verdict.outcome != Outcome::Unknown)
        html.put("p", "The model does not declare this property; it is always checked.");
    if (!verdict.reason.empty()) html.open("p").text("Why: ").prose(verdict.reason).close("p");
    for (const std::string& note : verdict.notes) html.open("p").text("Note: ").prose(note).close("p");
    html.open("p", {{"class", "remark"}})
        .text("Assumptions: ")
        .prose(settings_text(content.report, answer) + ".")
        .close("p");
    if (content.certificate)
        html.put("p", "Certificate: " + certificate_text(*content.certificate, verdict.property) + ".",
                 {{"class", "remark"}});
    const bool witness = verdict.outcome == Outcome::Holds;
    if (answer.trace) add_play(html, *answer.trace, verdict.property, witness ? "witness" : "counterexample");
    html.close("details");
}

/// Adds the trials of remedies. The durations of the trials are omitted, so that the same input always results in the
/// same page.
void add_remedies(const PageContent& content, Html& html) {
    const std::vector<std::string> lines = remedies_text(content.trials, false);
    if (lines.empty()) return;
    html.open("div", {{"class", "remedies"}}).open("p").prose("Options of `check`: " + lines.front()).close("p");
    if (lines.size() > 1) html.open("ul");
    for (std::size_t i = 1; i < lines.size(); ++i) html.open("li").prose(lines[i]).close("li");
    if (lines.size() > 1) html.close("ul");
    html.close("div");
}

void add_run_as_text(const Playable& playable, Html& html) {
    html.put("h3", playable.title);
    if (playable.run->rows.size() > longest_table) {
        html.put("p", fmt::format("The {} rows of this run are omitted; `grafverif check` prints them.",
                                  playable.run->rows.size()));
        return;
    }
    std::ostringstream table;
    print_trace(*playable.run, table);
    html.put("pre", table.str());
    if (!playable.end.empty()) html.put("p", playable.end);
}

// -- programs ---------------------------------------------------------------------------------------------------------

/// Adds an element with the lines of a program. The player reads the lines from this element.
void add_listing(const PageContent& content, const ChartContent& one, const std::string& id, Html& html) {
    const Program& program = *content.model.charts[one.chart].program;
    const ProgramListing& listing = one.program->listing;
    const std::string file = content.sources[program.units[program.main].origin.source].name;
    html.open("details").put("summary",
                             fmt::format("{} ({})", file,
                                         listing.begins.empty() ? "statements in Structured Text"
                                                                : counted(listing.lines.size(), "line", "lines")));
    // Starts with a line feed, because HTML parsers ignore a line feed at the beginning of `pre`.
    std::string text = "\n";
    for (const std::string& line : listing.lines) text += line + '\n';
    html.put("pre", text, {{"id", id}, {"class", "source"}}).close("details");
}

// -- findings, coverage -----------------------------------------------------------------------------------------------

void add_finding(const PageContent& content, const Analysis& analysis, const Finding& finding, Html& html) {
    html.open("li", {{"class", "finding"}});
    html.put("strong", word(finding.level)).text(" ").prose(finding.message).text(" ");
    html.put("code", finding.code)
        .put("span", " " + file_and_line(content.sources, finding.origin), {{"class", "remark"}});
    for (const Finding::Related& related : finding.related)
        html.open("p", {{"class", "remark"}})
            .prose(related.message + " (" + file_and_line(content.sources, related.where) + ")")
            .close("p");
    if (finding.accepted) html.put("p", "Accepted: " + *finding.accepted);
    if (finding.timing == Finding::Timing::Unconfirmed)
        html.put("p", "Unconfirmed: no times were found at which this trace is possible.");
    if (finding.evidence) add_play(html, *finding.evidence, evidence_name(content, analysis, finding), "evidence");
    html.close("li");
}

void add_open_queries(const Analysis& analysis, Html& html) {
    if (analysis.open.empty()) return;
    html.put("p", "The analysis is incomplete: " + analysis.obstacle + ".");
    html.open("details")
        .put("summary", counted(analysis.open.size(), "undecided check", "undecided checks"))
        .open("ul");
    for (const OpenQuestion& open : analysis.open)
        html.put("li", fmt::format("{} {} ({})", open.code, open.subject, open_text(open)));
    html.close("ul").close("details");
}

/// `yes`: names of the steps (transitions) that are active (cleared) in at least one run of the page. `no`: names of
/// all other steps (transitions).
struct Used {
    std::vector<std::string> yes = {}, no = {};
    void add(const std::string& name, bool used) { (used ? yes : no).push_back(name); }
};

void add_used(std::string_view what, const Used& used, Html& html) {
    const std::size_t all = used.yes.size() + used.no.size();
    html.open("tr").put("th", what, {{"scope", "row"}}).put("td", fmt::format("{} of {}", used.yes.size(), all));
    html.put("td", used.no.empty() ? "none" : listed(used.no)).close("tr");
}

void add_coverage_of(const PageContent& content, std::size_t place, Html& html) {
    const Chart& chart = drawn_chart(content, content.charts[place]);
    std::vector<bool> steps(chart.steps.size()), transitions(chart.transitions.size());
    for (const Playable& playable : playable_runs(content))
        for (std::size_t k = 0; k < playable.charts.size(); ++k) {
            if (playable.charts[k] != place || k >= playable.run->controllers.size()) continue;
            const ChartRun& run = *playable.run;
            const ChartRun::Controller& controller = run.controllers[{static_cast<std::uint32_t>(k)}];
            std::set<Id<ChartRun::Step>> active;
            std::set<Id<ChartRun::Transition>> cleared;
            for (const ChartRun::Event& moment : run.moments) {
                active.insert(moment.after.situation.begin(), moment.after.situation.end());
                for (const ChartRun::Act& act : moment.acts)
                    if (act.evolves) cleared.insert(act.fired.begin(), act.fired.end());
            }
            for (std::size_t s = 0; s < steps.size(); ++s) steps[s] = steps[s] || active.contains(controller.steps[s]);
            for (std::size_t t = 0; t < transitions.size(); ++t)
                transitions[t] = transitions[t] || cleared.contains(controller.transitions[t]);
        }
    Used used_steps, used_transitions;
    for (const Id<Chart::Step> id : chart.steps.ids()) used_steps.add(step_variable(chart, id), steps[id.index]);
    for (const Id<Chart::Transition> id : chart.transitions.ids())
        used_transitions.add(chart.transitions[id].name, transitions[id.index]);
    html.put("h3", chart.name).open("table");
    html.open("thead").open("tr").put("th", "").put("th", "used").put("th", "not used").close("tr").close("thead");
    html.open("tbody");
    add_used("steps", used_steps, html);
    add_used("transitions", used_transitions, html);
    html.close("tbody").close("table");
}

}  // namespace

void begin_property(const PropertyLook& look, const std::string& name, std::string_view text, std::string_view outcome,
                    bool folded, Html& html) {
    Html::Attributes attributes = {{"class", std::string("property ") + look.kind}, {"id", "property-" + name}};
    if (!folded) attributes.emplace_back("open", "");
    html.open("details", attributes).open("summary");
    html.put("span", look.mark, {{"class", "mark"}, {"aria-hidden", "true"}}).put("strong", name);
    if (!text.empty()) html.put("span", text, {{"class", "prose"}});
    html.put("span", outcome, {{"class", "outcome"}}).close("summary");
}

void add_formula(const PageContent& content, Id<ClosedLoop> loop, const std::string& property, Html& html) {
    const std::string formula = expectation_text(content.model, loop, property, content.sources);
    if (!formula.empty()) html.open("pre", {{"class", "formula"}}).put("code", formula).close("pre");
}

void add_verdicts(const PageContent& content, Html& html) {
    begin_section(html, "verdicts", "Properties");
    const std::vector<const Property*> without = left_out(content);
    if (content.report.answers.empty() && without.empty())
        html.open("p", {{"class", "empty"}})
            .prose(
                "There are no properties. Declare one in the closed loop, for example `property NAME: never A && B;`, "
                "and create the report again.")
            .close("p");
    for (const Property* property : without) {
        html.open("details", {{"class", "property unknown"}, {"id", "property-" + property->name}, {"open", ""}});
        html.open("summary").put("span", "?", {{"class", "mark"}, {"aria-hidden", "true"}});
        html.open("strong").text(property->name).close("strong");
        html.put("span", "unknown", {{"class", "outcome"}}).close("summary");
        html.put("p", "This model does not support the property; see the warnings.").close("details");
    }
    for (const PropertyResult& answer : content.report.answers)
        if (look_of(answer.verdict).kind != std::string_view("ok")) add_result(content, answer, html);
    add_remedies(content, html);
    for (const PropertyResult& answer : content.report.answers)
        if (look_of(answer.verdict).kind == std::string_view("ok")) add_result(content, answer, html);
    html.close("section");
}

void add_runs(const PageContent& content, Html& html) {
    const std::vector<Playable> runs = playable_runs(content);
    if (runs.empty()) return;
    begin_section(html, "runs", "Runs");
    html.open("div", {{"id", "player"}}).open("noscript");
    html.put("p", "The player requires JavaScript.");
    html.close("noscript");
    for (const Playable& playable : runs) add_run_as_text(playable, html);
    html.close("div").close("section");
}

bool has_charts(const PageContent& content) {
    return std::ranges::any_of(content.charts, [](const ChartContent& each) { return !each.program; });
}

bool has_steps(const PageContent& content) {
    return std::ranges::any_of(
        content.charts, [&](const ChartContent& each) { return !each.program || !each.program->drawn.steps.empty(); });
}

const char* charts_title(const PageContent& content) {
    const bool programs =
        std::ranges::any_of(content.charts, [](const ChartContent& each) { return each.program.has_value(); });
    if (!programs) return "Charts";
    return has_charts(content) ? "Charts and programs" : "Programs";
}

void add_findings(const PageContent& content, Html& html) {
    begin_section(html, "findings", "Findings");
    html.put("p", "Defects and dead elements of each chart for all input sequences; no plant is assumed.",
             {{"class", "remark"}});
    for (const ChartContent& each : content.charts) {
        if (each.program) continue;
        const Analysis& analysis = each.analysis;
        html.put("h3", analysis.chart);
        html.open("details", {{"open", ""}});
        html.put("summary",
                 analysis.findings.empty() ? "no findings" : counted(analysis.findings.size(), "finding", "findings"));
        html.open("ul");
        for (const Finding& finding : analysis.findings) add_finding(content, analysis, finding, html);
        html.close("ul").close("details");
        add_open_queries(analysis, html);
        for (const std::string& note : analysis.notes)
            html.open("p", {{"class", "remark"}}).prose("Note: " + note).close("p");
        for (const std::string& failure : analysis.failures) html.put("p", failure, {{"class", "bad"}});
    }
    html.close("section");
}

void add_charts(const PageContent& content, Html& html) {
    begin_section(html, "charts", charts_title(content));
    for (std::size_t k = 0; k < content.charts.size(); ++k) {
        const ChartContent& each = content.charts[k];
        html.open("figure", {{"id", "chart-" + std::to_string(k)}});
        html.put("figcaption", content.model.charts[each.chart].name);
        if (!each.drawing.empty()) html.open("div", {{"class", "drawing"}}).trusted(each.drawing).close("div");
        else if (each.program)
            html.put("p", "The program contains no Sequential Function Chart, so it has no drawing.",
                     {{"class", "empty"}});
        html.close("figure");
        if (each.program) add_listing(content, each, "program-" + std::to_string(k), html);
    }
    html.close("section");
}

void add_equations(const PageContent& content, Html& html) {
    begin_section(html, "equations", "Equations");
    html.put("p", "The proofs are based on these equations, which define the semantics of each chart.",
             {{"class", "remark"}});
    for (const ChartContent& each : content.charts) {
        if (each.program) continue;
        std::ostringstream text;
        print_equations(text, each.equations);
        html.open("details").put("summary", each.equations.name).put("pre", text.str()).close("details");
    }
    html.close("section");
}

void add_coverage(const PageContent& content, Html& html) {
    const std::size_t runs = playable_runs(content).size();
    begin_section(html, "coverage", "Coverage");
    html.put("p",
             fmt::format("Steps that were active and transitions that were cleared in some run on this page ({}). This "
                         "is trace coverage, not proof coverage.",
                         counted(runs, "run", "runs")),
             {{"class", "remark"}});
    for (std::size_t k = 0; k < content.charts.size() && runs != 0; ++k)
        if (!drawn_chart(content, content.charts[k]).steps.empty()) add_coverage_of(content, k, html);
    html.close("section");
}

}  // namespace grafverif
