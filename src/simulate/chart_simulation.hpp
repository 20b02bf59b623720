// SPDX-License-Identifier: MIT
// ChartSimulation: interactive simulation of a single chart according to IEC 60848. Commands set inputs and let time
// pass. After each command, PLC cycles are executed until a cycle changes nothing. Inputs that one command sets change
// simultaneously.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "report/trace_rows.hpp"
#include "run/interpreter.hpp"
#include "simulate/settings.hpp"
#include "simulate/what_if.hpp"

namespace grafverif {

class ChartSimulation {
public:
    /// Requires that `derive` accepts `chart`, and that `chart` outlives the simulation.
    ChartSimulation(const Chart& chart, ExecutionMode mode, Detail detail);
    ChartSimulation(const ChartSimulation&) = delete;
    ChartSimulation& operator=(const ChartSimulation&) = delete;

    const ChartRun& recorded_run() const { return recorded_run_; }
    ChartRun with_trace_rows(Detail detail) const;

    /// Returns the proposed commands. Each proposed command changes one input to an adjacent value, and the new values
    /// do not violate more constraints than the current values.
    std::vector<Choice> choices() const;
    std::size_t choice_count() const { return settings().size(); }
    DelayBounds delay_bounds() const;
    /// Returns the constraints that the current inputs violate. A simulation permits inputs that violate constraints.
    std::vector<std::string> violated_constraints() const;

    /// The following functions have the same meaning as in LoopSimulation. A command that returns an error may have
    /// changed inputs and let time pass.
    std::string settle();
    std::string choose(std::size_t choice);
    std::string wait(std::int64_t milliseconds);
    std::string wait();
    std::optional<std::int64_t> soonest_ms() const { return next_end(); }
    std::string set(const std::vector<Setting>& settings);
    std::string act(std::string_view instance, std::string_view location);
    std::string force(std::string_view step, bool active);
    /// Returns the index of the row in which the user first forced a step to change, or nullopt if there is no such
    /// row. From this row on, the recording is not a run of the chart.
    std::optional<std::size_t> what_if_row() const { return what_if_row_; }
    bool back();
    /// Returns the number of commands that can be undone.
    std::size_t commands() const { return commands_.size(); }

private:
    using Made = std::variant<std::vector<Setting>, std::int64_t, WhatIfRun>;

    void power_on();
    std::vector<Setting> settings() const;
    std::vector<Id<Expr>> broken_by(const std::vector<std::int64_t>& inputs) const;
    std::string refusal(const Setting& setting) const;
    std::string make(const Made& command);
    void put(const WhatIfRun& trial);
    std::string follow();
    std::string cycle();
    void add_evolution_rows(const Cycle& made);
    void pass(std::int64_t milliseconds);
    std::optional<std::int64_t> next_end() const;
    ChartRun::Act act_of(bool reads) const;
    void add(ChartRun::Event moment);

    const Chart& chart_;
    ExecutionMode mode_;
    Detail detail_;
    std::vector<TimedElement> elements_;
    State state_ = {};
    std::vector<std::int64_t> inputs_ = {};  ///< value of each input variable
    std::int64_t time_ms_ = 0;
    ChartRun recorded_run_ = {};
    std::optional<TraceRowBuilder> teller_;
    std::vector<Made> commands_ = {};
    std::optional<std::size_t> what_if_row_ = {};
    bool broken_ = false;
};

}  // namespace grafverif
