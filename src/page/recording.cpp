// SPDX-License-Identifier: MIT
// Adds the verdicts on a recording to a page: for each chart, the first deviation and the run of an admissible timing;
// for the closed loops, the properties that the recorded values violate.
#include "report/charts/recording.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "page/data.hpp"
#include "page/parts.hpp"
#include "page/words.hpp"

namespace grafverif {

namespace {

using Kind = RecordingVerdict::Kind;

/// Returns the name of a property on the page. Because of the `.`, the result differs from the names of charts.
std::string name_of(const RecordedProperty& property) { return property.loop + "." + property.name; }

PropertyLook look_of(const RecordingVerdict& verdict) {
    switch (verdict.kind) {
    case Kind::Conforms: return {"ok", "✓"};
    case Kind::Deviates: return {"bad", "✗"};
    case Kind::Unknown: break;
    }
    return {"unknown", "?"};
}

/// Returns text about the first deviation, with its line in the recording; empty if there is no deviation.
std::string deviation_place_text(const RecordingReport& report, const RecordingVerdict& verdict) {
    if (!verdict.deviation) return {};
    return fmt::format("{}:{}: {}", report.log, verdict.deviation->line, deviation_text(*verdict.deviation));
}

void add_chart(const RecordingReport& report, const RecordingVerdict& verdict, Html& html) {
    begin_property(look_of(verdict), verdict.chart, "", word(verdict.kind), false, html);
    if (!verdict.reason.empty()) html.put("p", "Why: " + verdict.reason);
    if (verdict.deviation) {
        html.open("p").prose(deviation_place_text(report, verdict) + ".").close("p");
        html.put("p", "Active steps: " + verdict.deviation->situation);
        html.put("p", no_timing_text(verdict));
    }
    for (const ClockOffset& offset : verdict.offsets) html.open("p").prose(offset_text(offset)).close("p");
    if (!verdict.unrecorded.empty())
        html.put("p", "Outputs without a column, which are not checked: " + listed(verdict.unrecorded));
    if (!verdict.run_is_complete)
        html.put("p", fmt::format("The run begins at {}; earlier instants are omitted.",
                                  seconds_text(verdict.run.moments.front().after.time_ms)));
    if (can_be_played(verdict.run))
        html.put("button", verdict.deviation ? "▶ Play the run up to the deviation" : "▶ Play the recording",
                 {{"type", "button"}, {"class", "play"}, {"data-run", verdict.chart}});
    html.close("details");
}

/// Returns the last row of the run at or before `time_us`, or nothing if the run begins later.
std::optional<std::size_t> row_at(const ChartRun& run, std::int64_t time_us) {
    std::optional<std::size_t> row;
    for (std::size_t k = 0; k < run.rows.size() && 1000 * run.after(run.rows[k]).time_ms <= time_us; ++k) row = k;
    return row;
}

void add_property(const PageContent& content, const RecordedProperty& property, Html& html) {
    const RecordingReport& report = *content.recording;
    begin_property(property.violated ? PropertyLook{"bad", "✗"} : PropertyLook{"ok", "✓"}, name_of(property), "",
                   property.violated ? "violated" : "not violated by these samples", !property.violated, html);
    const auto loop = std::ranges::find(content.model.loops, property.loop, &ClosedLoop::name);
    const Id<ClosedLoop> id{static_cast<std::uint32_t>(loop - content.model.loops.begin())};
    add_formula(content, id, property.name, html);
    if (property.violated) {
        html.put("p", fmt::format("{}:{}: the values from {} on violate the property.", report.log, property.line,
                                  recording_time_text(property.time_us)));
        // If a chart has a deviation, its run ends before the end of the recording.
        const auto shows = [&](const RecordingVerdict& verdict) {
            return can_be_played(verdict.run) &&
                   (!verdict.deviation || property.time_us <= verdict.deviation->time_us) &&
                   std::ranges::any_of(content.model.loops[id].controllers, [&](const auto& controller) {
                       return content.model.charts[controller.chart].name == verdict.chart;
                   });
        };
        for (const RecordingVerdict& verdict : report.verdicts)
            if (const auto row = shows(verdict) ? row_at(verdict.run, property.time_us) : std::nullopt)
                html.open("p")
                    .put("a",
                         fmt::format("Show {} in the run of {}", recording_time_text(property.time_us), verdict.chart),
                         {{"href", fmt::format("#{}/{}", verdict.chart, *row)}})
                    .close("p");
    }
    html.close("details");
}

}  // namespace

SummaryItem summary_of(const RecordingReport& report) {
    const auto count = [&](Kind kind) {
        return static_cast<std::size_t>(std::ranges::count(report.verdicts, kind, &RecordingVerdict::kind));
    };
    const auto violated =
        static_cast<std::size_t>(std::ranges::count(report.properties, true, &RecordedProperty::violated));
    std::string text;
    if (const std::size_t deviating = count(Kind::Deviates); deviating != 0)
        text = fmt::format("deviates from {}", counted(deviating, "chart", "charts"));
    if (violated != 0)
        text += fmt::format("{}violates {}", text.empty() ? "" : " and ", counted(violated, "property", "properties"));
    const bool bad = !text.empty();
    const std::size_t unknown = count(Kind::Unknown);
    if (!bad && unknown == 0) text = fmt::format("conforms to {}", counted(report.verdicts.size(), "chart", "charts"));
    if (!text.empty()) text = "The recording " + text;
    if (unknown != 0)
        text += fmt::format("{} verdict is unknown for {}", text.empty() ? "The" : "; the",
                            counted(unknown, "chart", "charts"));
    text += '.';
    return {bad ? "bad" : unknown != 0 ? "unknown" : "ok", std::move(text)};
}

std::vector<Playable> recording_runs(const PageContent& content) {
    std::vector<Playable> runs;
    const RecordingReport& report = *content.recording;
    for (std::size_t k = 0; k < report.verdicts.size(); ++k) {
        const RecordingVerdict& verdict = report.verdicts[k];
        const std::string end = verdict.deviation ? deviation_place_text(report, verdict) : "end of the recording";
        runs.push_back({verdict.chart, "recording", verdict.chart + ": recording", end, "", &verdict.run, {k}});
    }
    return runs;
}

void add_recording(const PageContent& content, Html& html) {
    const RecordingReport& report = *content.recording;
    html.open("section", {{"id", "recording"}}).put("h2", "Recording");
    html.put("p", summary_text(report) + ".", {{"class", "remark"}});
    for (const RecordingVerdict& verdict : report.verdicts) add_chart(report, verdict, html);
    for (const bool violated : {true, false})
        for (const RecordedProperty& property : report.properties)
            if (property.violated == violated) add_property(content, property, html);
    html.close("section");
}

}  // namespace grafverif
