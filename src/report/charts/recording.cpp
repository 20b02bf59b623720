// SPDX-License-Identifier: MIT
#include "report/charts/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "report/json_trace.hpp"
#include "report/terminal.hpp"
#include "support/json_text.hpp"
#include "support/printable.hpp"

namespace grafverif {

namespace {

using Json = nlohmann::ordered_json;

/// Returns the length of the final interval of the recording in which a deviation may remain undetected: four times the
/// jitter plus twice the maximum offset of a clock. The controller reads an input within one jitter after its change.
/// The resulting output is recorded within two further jitters. In addition, the recording must be known for one jitter
/// after the next instant. Twice the offset is added: a clock with a negative offset records a change earlier, and the
/// recording is known up to a time only when all clocks have passed this time.
std::int64_t undecided_us(const RecordingReport& report) {
    return std::min(4 * report.jitter_us + 2 * report.skew_us, report.last_us - report.first_us);
}

std::string short_time_text(std::int64_t us) {
    return us % 1000 == 0 ? fmt::format("{} ms", us / 1000) : fmt::format("{} us", us);
}

std::string verdict_text(RecordingVerdict::Kind kind, Colour colour) {
    const Outcome shown = kind == RecordingVerdict::Kind::Conforms   ? Outcome::Holds
                          : kind == RecordingVerdict::Kind::Deviates ? Outcome::Violated
                                                                     : Outcome::Unknown;
    return coloured(word(kind), shown, colour);
}

/// True if text and JSON contain the complete run from power-on.
bool is_printed_completely(const RecordingVerdict& verdict) {
    return verdict.run_is_complete && verdict.run.moments.size() <= printed_instants;
}

/// Returns the part of the run that text and JSON contain, even if an HTML report contains a longer part.
ChartRun printed_run(ChartRun run) {
    if (run.moments.size() <= printed_instants) return run;
    const std::size_t omitted = run.moments.size() - printed_instants;
    const auto end = static_cast<std::ptrdiff_t>(omitted);
    run.moments.erase(run.moments.begin(), run.moments.begin() + end);
    run.rows.erase(run.rows.begin(), run.rows.begin() + end);  // each instant has one row
    for (ChartRun::Row& row : run.rows) row.moment -= omitted;
    return run;
}

void print_deviation(const RecordingVerdict& verdict, const RecordingReport& report, std::ostream& out) {
    const Deviation& deviation = *verdict.deviation;
    out << fmt::format("  {}:{}: {}\n", printable(report.log), deviation.line, printable(deviation_text(deviation)));
    out << fmt::format("  active steps: {}\n", printable(deviation.situation));
    out << "  " << no_timing_text(verdict) << " The timing that agrees with the longest part of the recording"
        << (is_printed_completely(verdict) ? ":\n" : " ends with:\n");
    print_trace(printed_run(verdict.run), out);
}

}  // namespace

std::string recording_time_text(std::int64_t us) {
    if (us < 0) return "-" + recording_time_text(-us);
    std::string text = fmt::format("{}.{:06}", us / 1'000'000, us % 1'000'000);
    text.resize(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text + " s";
}

std::string deviation_text(const Deviation& deviation) {
    const std::string time = recording_time_text(deviation.time_us);
    if (deviation.missing_change)
        return fmt::format("`{}` is {}, but the chart sets it to {} at {}", deviation.output, deviation.recorded,
                           deviation.allowed, time);
    return fmt::format("`{}` changes to {} at {}, but the chart requires {}", deviation.output, deviation.recorded,
                       time, deviation.allowed);
}

std::string no_timing_text(const RecordingVerdict& verdict) {
    return fmt::format("No admissible timing explains the recording{}.",
                       !verdict.offsets.empty() ? " with any clock offset within the bounds" : "");
}

std::string offset_text(const ClockOffset& offset) {
    std::string columns;
    for (const std::string& column : offset.columns) columns += (columns.empty() ? "`" : ", `") + column + "`";
    return fmt::format("clock offset of {}: {} to {} (--skew {})", columns, recording_time_text(offset.low_us),
                       recording_time_text(offset.high_us), short_time_text(offset.bound_us));
}

std::string summary_text(const RecordingReport& report) {
    std::string text = fmt::format("{} sample{} of {} from {} to {}, jitter {}", report.samples,
                                   report.samples == 1 ? "" : "s", report.log, recording_time_text(report.first_us),
                                   recording_time_text(report.last_us), short_time_text(report.jitter_us));
    if (report.skew_us != 0) text += ", skew " + short_time_text(report.skew_us);
    const auto conforms = [](const RecordingVerdict& one) { return one.kind == RecordingVerdict::Kind::Conforms; };
    if (undecided_us(report) != 0 && std::ranges::any_of(report.verdicts, conforms))
        text +=
            fmt::format("; the last {} of the recording are inconclusive", recording_time_text(undecided_us(report)));
    return text;
}

void print_recording(const RecordingReport& report, Colour colour, std::ostream& out) {
    for (const RecordingVerdict& verdict : report.verdicts) {
        out << fmt::format("{}: {}\n", printable(verdict.chart), verdict_text(verdict.kind, colour));
        if (!verdict.reason.empty()) out << "  " << printable(verdict.reason) << '\n';
        if (verdict.deviation) print_deviation(verdict, report, out);
        for (const ClockOffset& offset : verdict.offsets) out << "  " << printable(offset_text(offset)) << '\n';
    }
    for (const RecordedProperty& property : report.properties)
        if (property.violated)
            out << fmt::format("property {}: violated\n  {}:{}: the values from {} on violate it\n",
                               printable(property.name), printable(report.log), property.line,
                               recording_time_text(property.time_us));
        else out << fmt::format("property {}: not violated by these samples\n", printable(property.name));
    out << printable(summary_text(report)) << '\n';
}

std::string recording_json(const RecordingReport& report) {
    const auto seconds = [](std::int64_t us) { return static_cast<double>(us) / 1e6; };
    Json verdicts = Json::array();
    for (const RecordingVerdict& verdict : report.verdicts) {
        Json deviation = nullptr;
        if (verdict.deviation)
            deviation = {
                {"time", seconds(verdict.deviation->time_us)}, {"line", verdict.deviation->line},
                {"output", verdict.deviation->output},         {"recorded", verdict.deviation->recorded},
                {"allowed", verdict.deviation->allowed},       {"situation", verdict.deviation->situation},
                {"complete", is_printed_completely(verdict)},  {"trace", trace_json(printed_run(verdict.run))}};
        Json offsets = Json::array();
        for (const ClockOffset& offset : verdict.offsets)
            offsets.push_back({{"columns", offset.columns},
                               {"bound", seconds(offset.bound_us)},
                               {"low", seconds(offset.low_us)},
                               {"high", seconds(offset.high_us)}});
        verdicts.push_back({{"chart", verdict.chart},
                            {"verdict", word(verdict.kind)},
                            {"reason", text_or_null(verdict.reason)},
                            {"offsets", offsets},
                            {"unrecorded", verdict.unrecorded},
                            {"deviation", deviation}});
    }
    Json properties = Json::array();
    for (const RecordedProperty& property : report.properties) {
        Json one = {{"name", property.name}, {"loop", property.loop}, {"violated", property.violated}};
        one["time"] = property.violated ? Json(seconds(property.time_us)) : Json(nullptr);
        one["line"] = property.violated ? Json(property.line) : Json(nullptr);
        properties.push_back(std::move(one));
    }
    return json_text({{"log", report.log},
                      {"jitter", seconds(report.jitter_us)},
                      {"skew", seconds(report.skew_us)},
                      {"samples", report.samples},
                      {"from", seconds(report.first_us)},
                      {"to", seconds(report.last_us)},
                      {"undecided", seconds(undecided_us(report))},
                      {"stopped", report.stopped},
                      {"charts", verdicts},
                      {"properties", properties}}) +
           "\n";
}

}  // namespace grafverif
