// SPDX-License-Identifier: MIT
// ProgramControllerReplay: replays a controller of a ChartRun whose behaviour is a PLC program. Each scan of the run is
// executed by ProgramRun with the inputs that were sampled in the run. The replay uses neither the equations nor the
// network.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart_run.hpp"
#include "run/program/interpreter.hpp"
#include "run/scan_replay.hpp"

namespace grafverif {

class ProgramControllerReplay {
public:
    /// All arguments must outlive the object.
    ProgramControllerReplay(const ChartRun& run, const ChartRun::Controller& controller, const Program& program);

    /// Lets `milliseconds` pass. Returns an error message if the task cycle does not allow this delay; otherwise an
    /// empty string.
    std::string pass(std::int64_t milliseconds);
    /// Executes an act of the controller in the run. Returns the differences between the run and the program, or an
    /// empty string if they agree.
    std::string does(const ChartRun::Act& act, const ChartRun::State& before, const ChartRun::State& after);

    /// From now on, adds the executed statements of each scan to `log`, unless `log` is null.
    void write_to(ScanLog* log) { log_ = log; }

    /// Returns the number of scans after the first one.
    std::size_t evolutions() const { return evolutions_; }
    /// True if both the run and the program have a fault. Events after the fault are not compared.
    bool raced() const { return raced_; }
    std::optional<ProgramFault> fault() const;
    const std::string& name() const { return controller_->name; }

private:
    /// Cells in the order of the signals or steps of the controller.
    struct Cells {
        std::vector<std::size_t> inputs = {}, outputs = {}, internals = {}, steps = {};
    };

    std::string scan(const ChartRun::Act& act, const ChartRun::State& after);
    std::string fault_difference(const ChartRun::Act& act);
    std::string difference(const std::vector<std::size_t>& cells, const std::vector<Id<ChartRun::Signal>>& signals,
                           const ChartRun::State& now) const;
    std::string situation_difference(const ChartRun::State& now) const;
    /// Returns the values of the outputs, the steps and the internal variables of the run.
    std::vector<std::int64_t> kept() const;
    /// Returns the values of all internal variables.
    std::vector<std::int64_t> hidden() const;

    const ChartRun* run_;
    const ChartRun::Controller* controller_;
    ProgramRun interpreter_;
    ScanReplay scans_;
    Cells cells_ = {};
    std::vector<Id<ChartRun::Signal>> internals_ = {};  ///< signals of `cells_.internals`
    std::vector<std::int64_t> inputs_ = {};             ///< sampled values, in the order of the controller's inputs
    std::size_t evolutions_ = 0;
    bool over_ = false, raced_ = false;
    ScanLog* log_ = nullptr;
};

/// Executes the scans of one controller of a run that agrees with its program. For each scan, `visit` is called with
/// the index of its event and with its statements, until `visit` returns false. A scan with a run-time fault is the
/// last one; its log ends at the fault.
void replay_scans(const ChartRun& run, Id<ChartRun::Controller> controller, const Program& program,
                  const std::function<bool(std::size_t event, const ScanLog& log)>& visit);

}  // namespace grafverif
