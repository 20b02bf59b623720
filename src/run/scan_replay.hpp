// SPDX-License-Identifier: MIT
// ScanReplay: checks the scans of one controller in a run against its task cycle (TaskCycle), independently of the
// translation. The first scan is at power-on; the time from each scan to the next is in the range of the cycle. A scan
// takes no time and has one evolution, or in a search for stability all evolutions up to a stable one; then the outputs
// are written. All its evolutions read the inputs as they are at its start, and no delay of a timer elapses between
// them. Without a task cycle, every run is accepted.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

class ScanReplay {
public:
    /// Both arguments must outlive the object.
    ScanReplay(const ChartRun& run, const ChartRun::Controller& controller);

    /// Each of the following functions returns an error message or an empty string.
    std::string pass(std::int64_t milliseconds);
    /// `before` is the state before the act.
    std::string act(const ChartRun::Act& act, const ChartRun::State& before);

    /// Reports the result of an act: `stable` is that of its evolution, if it has one; `writes`: outputs were written.
    void done(std::optional<bool> stable, bool writes);

private:
    std::string begin(const ChartRun::Act& act, const ChartRun::State& before);
    std::string timers_fault(const ChartRun::Act& act);

    const ChartRun& run_;
    const ChartRun::Controller& controller_;
    bool has_started_ = false;               ///< the scan at power-on has begun
    bool is_over_ = true;                    ///< no scan is in progress
    bool must_write_ = false;                ///< the last evolution of the scan has ended; its outputs are not written
    std::int64_t since_ms_ = 0;              ///< time since the start of the last scan
    std::vector<std::int64_t> inputs_ = {};  ///< at the start of the scan
    std::vector<bool> timers_ = {};          ///< as sampled by the last evolution of the scan; empty before the first
};

}  // namespace grafverif
