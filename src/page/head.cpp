// SPDX-License-Identifier: MIT
// Adds the head of a page: the summary verdict and the assumptions.
#include <fmt/format.h>

#include <algorithm>

#include "page/data.hpp"
#include "page/parts.hpp"
#include "page/terms.hpp"
#include "page/words.hpp"
#include "report/report.hpp"
#include "syntax/print/chart.hpp"
#include "syntax/print/constants.hpp"

namespace grafverif {

namespace {

std::size_t undecided(const PageContent& content) {
    const Tally count = tally(content.report);
    return count.unknown + count.undeclared_unknown + left_out(content).size();
}

/// Returns the number of findings with level `error` in the analyses of the charts. Accepted findings are not counted.
std::size_t errors_found(const PageContent& content) {
    std::size_t errors = 0;
    for (const ChartContent& each : content.charts)
        errors += static_cast<std::size_t>(std::ranges::count_if(each.analysis.findings, [](const Finding& finding) {
            return finding.level == Finding::Level::Error && !finding.accepted;
        }));
    return errors;
}

/// Returns text about the errors and open checks of the analyses of the charts; an empty string if the analyses are
/// complete and found no errors.
std::string errors_text(const PageContent& content) {
    if (const std::size_t errors = errors_found(content); errors != 0)
        return "the chart analysis found " + counted(errors, "error", "errors");
    const bool complete =
        std::ranges::all_of(content.charts, [](const ChartContent& each) { return each.analysis.open.empty(); });
    return complete ? "" : "the chart analysis is incomplete";
}

/// Returns the summary of the page. The summary is positive only if every verdict is as expected, no property holds
/// vacuously, and the analyses of the charts are complete and found no errors.
SummaryItem glance_of(const PageContent& content) {
    if (content.faults) return summary_of(*content.faults);
    if (content.tuning) return summary_of(*content.tuning);
    if (content.recording) return summary_of(*content.recording);
    const Report& report = content.report;
    const Tally count = tally(report);
    const bool analysis_failed =
        std::ranges::any_of(content.charts, [](const ChartContent& each) { return !each.analysis.failures.empty(); });
    if (!report.failures.empty() || analysis_failed)
        return {"bad", "Internal error: the results fail an internal check, such as the replay of a trace."};
    if (!report.error_traces.empty()) return {"bad", "Model error."};
    if (count.unexpected != 0)
        return {"bad", fmt::format("{} unexpected.", counted(count.unexpected, "verdict is", "verdicts are"))};
    if (const std::size_t open = undecided(content); open != 0)
        return {"unknown", fmt::format("{} unknown.", counted(open, "verdict is", "verdicts are"))};
    if (count.holds + count.violated == 0) return {"unknown", "There are no properties."};
    std::string words =
        fmt::format("Every {}{} {}", count.violated == 0 ? "property" : "verdict",
                    content.requested.empty() ? "" : " selected", count.violated == 0 ? "holds" : "is as expected");
    const auto vacuous = static_cast<std::size_t>(
        std::ranges::count_if(report.answers, [](const PropertyResult& answer) { return answer.verdict.vacuous; }));
    if (vacuous != 0) words += fmt::format(", {} vacuously", vacuous);
    const std::string errors = errors_text(content);
    if (errors.empty()) return {vacuous == 0 ? "ok" : "unknown", words + "."};
    return {"unknown", fmt::format("{}; {} (see Findings).", words, errors)};
}

std::string tally_text(const PageContent& content) {
    const Tally count = tally(content.report);
    std::vector<std::string> words;
    if (count.holds != 0) words.push_back(counted(count.holds, "holds", "hold"));
    if (count.violated != 0) words.push_back(fmt::format("{} violated", count.violated));
    if (const std::size_t open = undecided(content); open != 0) words.push_back(fmt::format("{} unknown", open));
    return listed(words);
}

/// Returns the assumptions of all verdicts, one sentence each.
std::vector<std::string> assumptions(const PageContent& content) {
    const CheckSettings& settings = content.report.settings;
    std::vector<std::string> sentences;
    if (content.recording)
        return {
            "The controller executes all evolutions of a stability search in one scan.",
            "The recording begins when the controller is switched on, and contains every pulse of the inputs.",
            "Each recorded time differs from the time in the controller by at most the jitter plus the offset of the "
            "clock that recorded it."};
    if (!content.requested.empty())
        sentences.push_back("Only these properties were selected: " + listed(content.requested) + ".");
    if (!content.loop.valid() && !content.charts.empty() && content.charts.front().program) {
        sentences.push_back(
            fmt::format("The program was checked by the engine `{}` for any number of scans.", settings.engine));
        sentences.push_back("There is no plant: every input can have any value in each scan.");
        return sentences;
    }
    if (settings.untimed.empty())
        sentences.push_back(fmt::format(
            "Time: the {} engine checked the timed closed loop with a time unit of {}; a PLC cycle takes no time{}.",
            settings.engine, seconds_text(settings.time_unit_ms),
            settings.cycle.empty() ? "" : ", and scans start periodically (" + settings.cycle + ")"));
    else
        sentences.push_back(
            fmt::format("Time is not modelled: the {} engine checked the untimed model ({}){}{}.", settings.engine,
                        settings.untimed, settings.cycle.empty() ? "" : "; " + settings.cycle,
                        content.loop.valid() ? "; each verdict states its implication for the timed loop" : ""));
    if (!settings.constants.empty())
        sentences.push_back("Constants of the loop: " + constants_text(settings.constants) + ".");
    if (settings.mode == word(ExecutionMode::StabilitySearch))
        sentences.push_back(
            fmt::format("Stability search: a PLC reads its inputs before each evolution{}, and writes its outputs when "
                        "the situation is stable.",
                        settings.cycle.empty() ? "" : " (with a task cycle, once per scan)"));
    else if (settings.mode == word(ExecutionMode::EveryCycle))
        sentences.push_back("Every cycle: the PLC makes one evolution per cycle and writes its outputs in each cycle.");
    else sentences.push_back(fmt::format("Modes of the controllers: {}.", settings.mode));
    if (settings.grain == "phased")
        sentences.push_back("Grain phased: the plant and the timers can move between the phases of a PLC cycle.");
    else if (settings.grain == "atomic")
        sentences.push_back(
            "Grain atomic: the plant does not move during a PLC cycle; verdicts apply only to this model unless stated "
            "otherwise.");
    if (!content.loop.valid()) {
        sentences.push_back("There is no plant: every input can change at any time.");
        for (const ChartContent& each : content.charts)
            for (const Chart::Constraint& constraint : content.model.charts[each.chart].constraints)
                sentences.push_back("Input constraint, assumed for the findings, but not for the verdicts: " +
                                    term_text(content.model.charts[each.chart], constraint.condition));
        return sentences;
    }
    const ClosedLoop& loop = content.model.loops[content.loop];
    if (settings.untimed.starts_with("no plant")) {
        sentences.push_back("This model has no plant: every input can change at any time.");
        if (settings.untimed.find("constrained inputs") == std::string::npos) return sentences;
        for (const ClosedLoop::Constraint& constraint : loop.constraints)
            sentences.push_back(fmt::format("The inputs always satisfy {}: {}", constraint.name,
                                            term_text(content.model, loop, constraint.condition)));
        return sentences;
    }
    if (const std::string environment = environment_text(content.model, loop, settings.untimed.empty());
        !environment.empty())
        sentences.push_back("The environment behaves in every way that its components permit: " + environment + ".");
    return sentences;
}

}  // namespace

void add_head(const PageContent& content, Html& html) {
    html.open("header").put("h1", content.report.model);
    html.open("p", {{"class", "about"}}).put("code", content.file).text(" · grafverif " + content.version);
    if (!content.date.empty()) html.text(" · " + content.date);
    html.close("p");
    const SummaryItem glance = glance_of(content);
    html.open("p", {{"class", std::string("glance ") + glance.kind}}).put("strong", glance.words);
    if (is_about_verdicts(content)) html.put("span", tally_text(content));
    html.close("p");
    for (const ModelErrorTrace& each : content.report.error_traces)
        html.put("p", "Model error: " + each.message + " [" + each.code + "]", {{"class", "bad"}});
    for (const std::string& failure : content.report.failures) html.put("p", failure, {{"class", "bad"}});
    html.open("details", {{"class", "assumed"}, {"open", ""}}).put("summary", "Assumptions").open("ul");
    for (const std::string& sentence : assumptions(content)) html.put("li", sentence);
    html.close("ul").close("details");
    if (!content.warnings.empty())
        html.open("details", {{"class", "warnings"}, {"open", ""}})
            .put("summary", "Warnings")
            .put("pre", content.warnings)
            .close("details");
    html.close("header");
}

}  // namespace grafverif
