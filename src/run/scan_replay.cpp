// SPDX-License-Identifier: MIT
#include "run/scan_replay.hpp"

#include <fmt/format.h>

namespace grafverif {

ScanReplay::ScanReplay(const ChartRun& run, const ChartRun::Controller& controller)
    : run_(run), controller_(controller) {}

std::string ScanReplay::pass(std::int64_t milliseconds) {
    if (!controller_.cycle) return {};
    if (!has_started_) return "time passes before the scan at power-on";
    if (!is_over_) return "time passes during a scan";
    since_ms_ += milliseconds;
    if (since_ms_ <= controller_.cycle->most_ms) return {};
    return fmt::format("{} ms after the last scan, but the task cycle is at most {} ms", since_ms_,
                       controller_.cycle->most_ms);
}

std::string ScanReplay::act(const ChartRun::Act& act, const ChartRun::State& before) {
    if (!controller_.cycle) return {};
    if (act.starts || act.scans)
        if (std::string fault = begin(act, before); !fault.empty()) return fault;
    if (!act.begins && !act.samples && !act.evolves) return {};
    if (is_over_ || must_write_) return "an evolution outside the scans of the task cycle";
    if (!act.samples || controller_.mode == ExecutionMode::EveryCycle) return {};
    if (act.inputs != inputs_) return "an evolution reads input values that differ from those at the start of its scan";
    return timers_fault(act);
}

std::string ScanReplay::begin(const ChartRun::Act& act, const ChartRun::State& before) {
    if (act.scans && !is_over_) return "a scan begins before the last scan has ended";
    if (act.scans && run_.timed && since_ms_ < controller_.cycle->least_ms)
        return fmt::format("a scan begins {} ms after the last scan, but the task cycle is at least {} ms", since_ms_,
                           controller_.cycle->least_ms);
    if (act.starts == has_started_) return "exactly one scan, the first scan, must be at power-on";
    has_started_ = true;
    since_ms_ = 0;
    // In mode every-cycle, the first evolution is a complete scan.
    is_over_ = act.starts && controller_.mode == ExecutionMode::EveryCycle;
    inputs_.clear();
    for (const Id<ChartRun::Signal> input : controller_.inputs) inputs_.push_back(before.values[input.index]);
    timers_.clear();
    return {};
}

/// Returns an error message if a delay elapses during a scan: the output of a timer with a rise time t1 becomes true,
/// or the output of a timer with a fall time t2 becomes false.
std::string ScanReplay::timers_fault(const ChartRun::Act& act) {
    for (std::size_t k = 0; k < timers_.size(); ++k) {
        const ChartRun::Timer& timer = run_.timers[controller_.timers[k]];
        if (timers_[k] == act.timers[k] || (timers_[k] ? timer.fall_ms : timer.rise_ms) == 0) continue;
        return fmt::format("the delay of the timer of {} elapses during a scan", timer.watched);
    }
    timers_ = act.timers;
    return {};
}

void ScanReplay::done(std::optional<bool> stable, bool writes) {
    must_write_ = must_write_ || (stable && (*stable || controller_.mode == ExecutionMode::EveryCycle));
    if (!must_write_ || !writes) return;
    must_write_ = false;
    is_over_ = true;
}

}  // namespace grafverif
