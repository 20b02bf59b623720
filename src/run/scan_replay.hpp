// SPDX-License-Identifier: MIT
// ScanReplay: checks the scans of one controller in a run against its task cycle (TaskCycle), independently of the
// translation. The first scan is at power-on; the time from each scan to the next is in the range of the cycle. A scan
// takes no time. A scan consists of one evolution or, under stability search, of all evolutions up to a stable one.
// Then the outputs are written. All evolutions of a scan read the values that the inputs have at the start of the scan,
// and no delay of a timer elapses between these evolutions. Without a task cycle, every run is accepted.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

class ScanReplay {
public:
    /// `run` and `controller` must outlive the object.
    ScanReplay(const ChartRun& run, const ChartRun::Controller& controller);

    /// The functions `pass` and `act` return an error message, or an empty string if there is no error.
    std::string pass(std::int64_t milliseconds);
    /// `before` is the state before the act.
    std::string act(const ChartRun::Act& act, const ChartRun::State& before);

    /// Reports the result of an act. `stable` is true if the evolution of the act is stable, and empty if the act has
    /// no evolution. `writes` is true if outputs were written.
    void done(std::optional<bool> stable, bool writes);

private:
    std::string begin(const ChartRun::Act& act, const ChartRun::State& before);
    std::string timers_fault(const ChartRun::Act& act);

    const ChartRun& run_;
    const ChartRun::Controller& controller_;
    bool has_started_ = false;  ///< true if the scan at power-on has begun
    bool is_over_ = true;       ///< true if no scan is in progress
    bool must_write_ = false;  ///< true if the last evolution of the scan has ended and the outputs are not yet written
    std::int64_t since_ms_ = 0;              ///< time since the start of the last scan
    std::vector<std::int64_t> inputs_ = {};  ///< values of the inputs at the start of the scan
    /// Timer outputs as sampled by the last evolution of the scan; empty before the first evolution.
    std::vector<bool> timers_ = {};
};

}  // namespace grafverif
