// SPDX-License-Identifier: MIT
// Determines the verdict of RecordingCheck: kind, reason, deviation, run and offsets of clocks.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>

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

/// Determines the times of the stored instants for offsets that `zone`, the zone of the hypothesis at the end of the
/// check, permits: the offset of each clock is as near to zero as the previous ones permit.
RecordingCheck::ShownTiming RecordingCheck::timing(const Hypothesis& hypothesis, Zone zone) const {
    ShownTiming result;
    result.clocks.resize(first_clock + settings_.clocks.size());
    for (std::size_t clock = first_clock; clock < result.clocks.size(); ++clock) {
        result.clocks[clock] = nearest_to_zero(zone, clock);
        [[maybe_unused]] const bool possible = fix(zone, clock, result.clocks[clock]);
        assert(possible);
    }
    for (const Instant* instant = hypothesis.history.get(); instant != nullptr; instant = instant->previous.get())
        result.instants.push_back(instant);
    std::ranges::reverse(result.instants);
    for (const Instant* const instant : result.instants) {
        Zone bounds = instant->zone;
        bool possible = true;
        for (std::size_t clock = first_clock; possible && clock < result.clocks.size(); ++clock)
            possible = fix(bounds, clock, result.clocks[clock]);
        Ticks time = instant->typical.time + result.clocks[instant->typical.clock];
        // The offsets of a joined hypothesis can require another order of the events of its history (see `join`). The
        // bounds of the instant then do not apply.
        if (possible) time = std::clamp(time, bounds.lower(last), bounds.upper(last));
        result.times.push_back(result.times.empty() ? time : std::max(time, result.times.back()));
    }
    return result;
}

void RecordingCheck::add_run(const ShownTiming& timing, RecordingVerdict& verdict) const {
    verdict.run = project(source_, ExecutionMode::StabilitySearch);
    for (std::size_t k = 0; k < timing.instants.size(); ++k) {
        const Instant& instant = *timing.instants[k];
        append_instant(
            verdict.run, instant.typical.number == 0 ? "power-on" : "cycle", instant.reaction->fired,
            project(source_, *instant.reaction->after, instant.inputs, timing.times[k] / settings_.ticks_per_ms));
    }
    verdict.run_is_complete = timing.instants.empty() || timing.instants.front()->typical.number == 0;
}

std::int64_t RecordingCheck::microseconds(Ticks time) const {
    const Ticks unit = settings_.ticks_per_ms;
    return time / unit * 1000 + time % unit * 1000 / unit;
}

Deviation RecordingCheck::deviation(const ShownTiming& timing) const {
    const Hypothesis& hypothesis = end_->hypothesis;
    const Signal& signal = signals_[end_->signal];
    Deviation result;
    result.output = source_.variables[signal.variable].name;
    result.allowed = hypothesis.state->outputs[signal.variable.index];
    result.missing_change = end_->missing_change;
    if (end_->missing_change) {
        const std::size_t hidden = hypothesis.hidden[end_->signal];
        const TypicalTime& change = hypothesis.typical[hidden];
        Ticks time = change.time + timing.clocks[change.clock];
        for (std::size_t k = 0; k < timing.instants.size(); ++k)
            if (timing.instants[k]->typical.number == change.number) {
                time = timing.times[k];
                result.allowed = timing.instants[k]->reaction->after->outputs[signal.variable.index];
            }
        result.time_us = microseconds(time);
        result.line = line_at(hypothesis.zone.upper(hidden) + settings_.jitter - hypothesis.zone.lower(signal.clock));
        result.recorded = hypothesis.visible[end_->signal];
    } else {
        result.time_us = microseconds(end_->change.time);
        result.line = end_->change.line;
        result.recorded = end_->change.value;
    }
    result.situation = situation_text(source_, hypothesis.state->situation);
    return result;
}

/// Returns the range of the offset of each clock in `zones`, or nothing if there are no zones.
std::vector<ClockOffset> RecordingCheck::offsets(const std::vector<Zone>& zones) const {
    std::vector<ClockOffset> offsets;
    for (std::size_t k = 0; k < settings_.clocks.size() && !zones.empty(); ++k) {
        Ticks low = Zone::unbounded, high = -Zone::unbounded;
        for (const Zone& zone : zones) {
            low = std::min(low, -zone.upper(first_clock + k));
            high = std::max(high, -zone.lower(first_clock + k));
        }
        offsets.push_back({.low_us = microseconds(low), .high_us = microseconds(high)});
    }
    return offsets;
}

/// Sets the kind and the reason of the verdict if no timing is admissible, or if a limit ended the check.
void RecordingCheck::explain_end(RecordingVerdict& verdict) const {
    verdict.kind = RecordingVerdict::Kind::Unknown;
    if (limit_ != Limit::None) {
        const std::string remedy = settings_.clocks.empty() ? "reduce the jitter" : "reduce the jitter or the skew";
        verdict.reason = limit_ == Limit::Orders      ? "too many orders of events are possible; " + remedy
                         : limit_ == Limit::Reactions ? "too many possible sequences of instants between two samples; "
                                                        "record more samples or " +
                                                            remedy
                                                      : "stopped before the end of the log; no deviation up to this "
                                                        "sample";
    } else if (!problem_.empty() || !end_) {
        verdict.reason = fmt::format(
            "an admissible timing has a model error at {} ms, and no other timing explains the recording: {}",
            problem_time_ / settings_.ticks_per_ms, problem_);
    } else {
        verdict.kind = RecordingVerdict::Kind::Deviates;
    }
}

RecordingVerdict RecordingCheck::verdict() const {
    RecordingVerdict result{.chart = source_.name};
    if (!begun_) return result;
    const Hypothesis* shown = nullptr;
    std::vector<Zone> zones;  // of the timings that are admissible so far or, without such a timing, of `end_`
    for (const Hypothesis& hypothesis : hypotheses_)
        if (auto zone = zone_of_next(hypothesis)) {
            if (zones.empty()) shown = &hypothesis;
            zones.push_back(std::move(*zone));
        }
    if (hypotheses_.empty()) {
        explain_end(result);
        if (end_ && limit_ == Limit::None) shown = &end_->hypothesis;
        if (result.kind == RecordingVerdict::Kind::Deviates) zones.push_back(end_->hypothesis.zone);
    } else if (shown == nullptr) {
        shown = &hypotheses_.front();
    }
    result.offsets = offsets(zones);
    if (shown == nullptr) return result;
    const ShownTiming timing = this->timing(*shown, zones.empty() ? shown->zone : zones.front());
    add_run(timing, result);
    if (hypotheses_.empty()) result.deviation = deviation(timing);
    return result;
}

}  // namespace grafverif
