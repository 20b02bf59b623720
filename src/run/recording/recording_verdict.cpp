// SPDX-License-Identifier: MIT
// Determines the verdict of RecordingCheck: kind, reason, deviation, run and offsets of clocks.
#include <fmt/format.h>

#include <algorithm>

#include "run/project.hpp"
#include "run/recording/recording_check.hpp"
#include "run/scanner.hpp"

namespace grafverif {

/// Returns the line of the last sample that is not after `time`.
std::uint64_t RecordingCheck::line_at(Ticks time) const {
    std::uint64_t line = lines_.front().second;
    for (const auto& [begin, number] : lines_)
        if (begin <= time) line = number;
    return line;
}

void RecordingCheck::add_run(const Hypothesis& hypothesis, RecordingVerdict& verdict) const {
    std::vector<const Instant*> instants;
    for (const Instant* instant = hypothesis.history.get(); instant != nullptr; instant = instant->previous.get())
        instants.push_back(instant);
    std::ranges::reverse(instants);
    verdict.run = project(source_, ExecutionMode::StabilitySearch);
    for (const Instant* const instant : instants)
        append_instant(
            verdict.run, instant->number == 0 ? "power-on" : "cycle", instant->reaction->fired,
            project(source_, *instant->reaction->after, instant->inputs, instant->time / settings_.ticks_per_ms));
    verdict.run_is_complete = instants.empty() || instants.front()->number == 0;
}

std::int64_t RecordingCheck::microseconds(Ticks time) const {
    const Ticks unit = settings_.ticks_per_ms;
    return time / unit * 1000 + time % unit * 1000 / unit;
}

Deviation RecordingCheck::deviation() const {
    const Hypothesis& hypothesis = end_->hypothesis;
    const Signal& signal = signals_[end_->signal];
    Deviation result;
    result.output = source_.variables[signal.variable].name;
    result.allowed = hypothesis.state->outputs[signal.variable.index];
    result.missing_change = end_->missing_change;
    if (end_->missing_change) {
        const std::size_t hidden = hypothesis.hidden[end_->signal];
        result.time_us = microseconds(hypothesis.typical[hidden]);
        result.line = line_at(hypothesis.zone.upper(hidden) + settings_.jitter - hypothesis.zone.lower(signal.clock));
        result.recorded = hypothesis.visible[end_->signal];
        for (const Instant* instant = hypothesis.history.get(); instant != nullptr; instant = instant->previous.get())
            if (instant->time >= hypothesis.typical[hidden])
                result.allowed = instant->reaction->after->outputs[signal.variable.index];
    } else {
        result.time_us = microseconds(end_->change.time);
        result.line = end_->change.line;
        result.recorded = end_->change.value;
    }
    result.situation = situation_text(source_, hypothesis.state->situation);
    return result;
}

/// For each clock: the range of its offset in the timings that are admissible so far. If no timing is admissible: the
/// range in the timing that agrees with the longest part of the recording. The result is empty if a limit or a model
/// error ended the check.
std::vector<ClockOffset> RecordingCheck::offsets() const {
    std::vector<Zone> zones;
    for (const Hypothesis& hypothesis : hypotheses_)
        if (auto zone = zone_of_next(hypothesis)) zones.push_back(std::move(*zone));
    if (hypotheses_.empty() && end_ && limit_ == Limit::None && problem_.empty())
        zones.push_back(end_->hypothesis.zone);
    if (zones.empty()) return {};
    std::vector<ClockOffset> offsets;
    for (std::size_t k = 0; k < settings_.clocks.size(); ++k) {
        Ticks low = Zone::unbounded, high = -Zone::unbounded;
        for (const Zone& zone : zones) {
            low = std::min(low, -zone.upper(first_clock + k));
            high = std::max(high, -zone.lower(first_clock + k));
        }
        offsets.push_back({.low_us = microseconds(low), .high_us = microseconds(high)});
    }
    return offsets;
}

RecordingVerdict RecordingCheck::verdict() const {
    using Kind = RecordingVerdict::Kind;
    RecordingVerdict result{.chart = source_.name, .offsets = offsets()};
    if (!hypotheses_.empty()) add_run(hypotheses_.front(), result);
    if (!begun_ || !hypotheses_.empty()) return result;
    if (limit_ != Limit::None) {
        result.kind = Kind::Unknown;
        const std::string remedy = settings_.clocks.empty() ? "reduce `--jitter`" : "reduce `--jitter` or `--skew`";
        result.reason = limit_ == Limit::Orders      ? "too many orders of events are possible; " + remedy
                        : limit_ == Limit::Reactions ? "too many sequences of instants are possible between two "
                                                       "samples; record samples at shorter intervals, or " +
                                                           remedy
                                                     : "stopped before the end of the log; no deviation up to the last "
                                                       "sample read";
    } else if (!problem_.empty() || !end_) {
        result.kind = Kind::Unknown;
        result.reason = fmt::format(
            "an admissible timing has a model error at {} ms, and no other timing explains the recording: {}",
            problem_time_ / settings_.ticks_per_ms, problem_);
    } else {
        result.kind = Kind::Deviates;
    }
    if (!end_ || limit_ != Limit::None) return result;
    result.deviation = deviation();
    add_run(end_->hypothesis, result);
    return result;
}

}  // namespace grafverif
