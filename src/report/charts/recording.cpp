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

std::string time_text(std::int64_t us) {
    std::string text = fmt::format("{}.{:06}", us / 1'000'000, us % 1'000'000);
    text.resize(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text + " s";
}

/// Returns the length of the final interval of the recording in which a deviation may remain undetected: four times the
/// jitter. An instant reads an input within one jitter. The output of this instant is recorded within two further
/// jitters. In addition, the recording must be known for one jitter after the next instant.
std::int64_t undecided_us(const RecordingReport& report) {
    return std::min(4 * report.jitter_us, report.last_us - report.first_us);
}

std::string jitter_text(const RecordingReport& report) {
    return report.jitter_us % 1000 == 0 ? fmt::format("{} ms", report.jitter_us / 1000)
                                        : fmt::format("{} us", report.jitter_us);
}

std::string verdict_text(RecordingVerdict::Kind kind, Colour colour) {
    const Outcome shown = kind == RecordingVerdict::Kind::Conforms   ? Outcome::Holds
                          : kind == RecordingVerdict::Kind::Deviates ? Outcome::Violated
                                                                     : Outcome::Unknown;
    return coloured(word(kind), shown, colour);
}

void print_deviation(const Deviation& deviation, const RecordingReport& report, std::ostream& out) {
    out << fmt::format("  {}:{}: ", printable(report.log), deviation.line);
    if (deviation.missing_change)
        out << fmt::format("`{}` is {}, but the chart sets it to {} at {}\n", printable(deviation.output),
                           deviation.recorded, deviation.allowed, time_text(deviation.time_us));
    else
        out << fmt::format("`{}` changes to {} at {}, but the chart requires {}\n", printable(deviation.output),
                           deviation.recorded, time_text(deviation.time_us), deviation.allowed);
    out << fmt::format("  active steps: {}\n", printable(deviation.situation));
    out << "  No admissible timing explains the recording. The timing that explains most of it"
        << (deviation.run_is_complete ? ":\n" : " ends with:\n");
    print_trace(deviation.run, out);
}

}  // namespace

void print_recording(const RecordingReport& report, Colour colour, std::ostream& out) {
    for (const RecordingVerdict& verdict : report.verdicts) {
        out << fmt::format("{}: {}\n", printable(verdict.chart), verdict_text(verdict.kind, colour));
        if (!verdict.reason.empty()) out << "  " << printable(verdict.reason) << '\n';
        if (verdict.deviation) print_deviation(*verdict.deviation, report, out);
    }
    for (const RecordedProperty& property : report.properties)
        if (property.violated)
            out << fmt::format("property {}: violated\n  {}:{}: the values from {} on violate it\n",
                               printable(property.name), printable(report.log), property.line,
                               time_text(property.time_us));
        else out << fmt::format("property {}: not violated by these samples\n", printable(property.name));
    out << fmt::format("{} sample{} of {} from {} to {}, jitter {}", report.samples, report.samples == 1 ? "" : "s",
                       printable(report.log), time_text(report.first_us), time_text(report.last_us),
                       jitter_text(report));
    const auto conforms = [](const RecordingVerdict& one) { return one.kind == RecordingVerdict::Kind::Conforms; };
    if (report.jitter_us != 0 && std::ranges::any_of(report.verdicts, conforms))
        out << fmt::format("; the last {} of the recording are inconclusive", time_text(undecided_us(report)));
    out << '\n';
}

std::string recording_json(const RecordingReport& report) {
    const auto seconds = [](std::int64_t us) { return static_cast<double>(us) / 1e6; };
    Json verdicts = Json::array();
    for (const RecordingVerdict& verdict : report.verdicts) {
        Json deviation = nullptr;
        if (verdict.deviation)
            deviation = {{"time", seconds(verdict.deviation->time_us)},
                         {"line", verdict.deviation->line},
                         {"output", verdict.deviation->output},
                         {"recorded", verdict.deviation->recorded},
                         {"allowed", verdict.deviation->allowed},
                         {"situation", verdict.deviation->situation},
                         {"complete", verdict.deviation->run_is_complete},
                         {"trace", trace_json(verdict.deviation->run)}};
        verdicts.push_back({{"chart", verdict.chart},
                            {"verdict", word(verdict.kind)},
                            {"reason", text_or_null(verdict.reason)},
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
