// SPDX-License-Identifier: MIT
// LoopSimulation: interactive simulation of a closed loop. Commands choose moves of the plant and its environment, set
// inputs and let time pass. The remaining moves are executed automatically, in the following order, until a choice is
// required:
//
//   1  an urgent edge of the plant or its environment, if it is the only enabled urgent edge of its instance; for
//      example, sensors follow the plant
//   2  timers
//   3  PLC cycles
//   4  an edge that an invariant forces now, if it is the only such edge of its instance; for example, movements continue
//
// Between two PLC cycles, the user can also force a step to be active or inactive, to explore the consequences (what-if
// run).
//
// With Detail::Everything, no move is automatic: every edge is a choice.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/network.hpp"
#include "ir/network_run.hpp"
#include "report/trace_rows.hpp"
#include "run/manual_situation.hpp"
#include "run/project.hpp"
#include "simulate/settings.hpp"
#include "simulate/what_if.hpp"

namespace grafverif {

class LoopSimulation {
public:
    /// `charts` are the charts of the controllers. `network` and the charts must outlive the simulation.
    LoopSimulation(const Network& network, std::vector<const Chart*> charts, Detail detail);
    LoopSimulation(const LoopSimulation&) = delete;
    LoopSimulation& operator=(const LoopSimulation&) = delete;

    const ChartRun& recorded_run() const { return recorded_run_; }
    ChartRun with_trace_rows(Detail detail) const { return with_rows(project(network_, run_), detail); }

    /// Returns the possible choices, or an empty list after a race.
    std::vector<Choice> choices() const;
    std::size_t choice_count() const { return fires().size(); }
    DelayBounds delay_bounds() const;

    /// Each of the following functions executes one command: the moves of the command, followed by the automatic moves.
    /// The result is an error message or an empty string. After an error, some moves may have been performed.
    std::string settle();
    /// Executes a choice. `choice` is the index in the result of choices().
    std::string choose(std::size_t choice);
    std::string wait(std::int64_t milliseconds);
    /// Lets time pass until an invariant prevents further delay or a disabled edge becomes enabled.
    std::string wait();
    /// Executes the first choice after which the input, or the variable of the plant, has the given value.
    std::string set(const std::vector<Setting>& settings);
    /// Takes the first edge of `instance` to `location`; if `location` is empty, the first enabled edge.
    std::string act(std::string_view instance, std::string_view location);
    /// Forces a step to be active or inactive, independently of the rules.
    std::string force(std::string_view step, bool active);
    /// Returns the index of the row in which the user first forced a step to change, or nullopt if there is no such
    /// row. From this row on, the recording is not a run of the network.
    std::optional<std::size_t> what_if_row() const { return what_if_row_; }
    /// Returns the time until an invariant prevents further delay or a disabled edge becomes enabled, whichever is
    /// earlier; nullopt if neither occurs.
    std::optional<std::int64_t> soonest_ms() const;
    /// Returns the location of the instance after an event of the recorded run, or nullopt if there is no such
    /// instance.
    std::optional<std::string> location_of(std::string_view instance, std::size_t moment) const;
    /// Returns the name of the variable that is connected to a port of an instance. For an output such as `Main.FLOW`,
    /// the result is the variable that the output writes; for an input, the result is the variable that the input
    /// reads. The result is empty if there is no such port, or if the port is an input that is bound to a term.
    std::string port_variable(std::string_view name) const;
    /// Undoes the last command. Returns false if there is no command to undo.
    bool back();
    /// Returns the number of commands that can be undone.
    std::size_t commands() const { return commands_.size(); }

private:
    /// A change of a step that the user has forced. `at` is the index of the next move.
    struct Forced {
        std::size_t at = 0;
        WhatIfRun trial = {};
    };
    /// The state of the simulation before a command, for undo.
    struct Mark {
        std::size_t moves = 0, what_if_runs = 0;
    };

    void power_on();
    void begin_command() { commands_.push_back({run_.moves.size(), what_if_runs_.size()}); }
    void put(const WhatIfRun& trial);
    ManualSituation forced(const WhatIfRun& trial) const;
    std::vector<Fire> fires() const;
    std::string choose(const Fire& fire);
    /// Executes one edge without automatic moves. Returns false if the edge is disabled or causes a model error.
    bool move(const Move& move, std::string& problem);
    std::string command_of(const std::vector<Fire>& moves, std::size_t choice) const;
    std::string follow();
    std::optional<Fire> next_by_itself() const;
    std::string pass(std::int64_t units);
    std::string waiting_for() const;
    std::string problem_of(const Step& step, const Move& move) const;

    const Network& network_;
    std::vector<const Chart*> charts_;  ///< chart of each controller
    Detail detail_;
    NetworkState state_;
    Run run_ = {};
    ChartRun recorded_run_ = {};
    std::optional<NetworkProjection> projection_;  ///< projection that appends the moves of the run to `recorded_run_`
    std::optional<TraceRowBuilder> teller_;
    std::vector<Forced> what_if_runs_ = {};
    std::vector<Mark> commands_ = {};
    std::optional<std::size_t> what_if_row_ = {};
    bool broken_ = false;
};

}  // namespace grafverif
