// SPDX-License-Identifier: MIT
// Scanner: executes a chart as a PLC does, scan by scan: inputs are read, one cycle is executed (with stability search
// if the mode has it), outputs are written; time passes between scans.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "run/interpreter.hpp"

namespace grafverif {

/// In order of declaration.
std::vector<Id<Chart::Variable>> variables_of_kind(const Chart& chart, Chart::VariableKind kind);

/// `{2, 5}`
std::string situation_text(const Chart& chart, const std::vector<bool>& situation);

/// Message for a chart that repeats the situations of `endless`, at least one, forever; with its code.
std::string instability_text(const Chart& chart, const std::vector<std::vector<bool>>& endless);
/// Message for stored actions that give `variable` different values; for contradictory forcing orders if the name is
/// empty.
std::string race_text(std::string_view variable);

/// Reason why a PLC cannot execute `cycle`; empty if it can.
std::string problem_in(const Chart& chart, const Cycle& cycle);

class Scanner {
public:
    /// `chart` must outlive the scanner.
    Scanner(const Chart& chart, ExecutionMode mode) : chart_(chart), mode_(mode), state_(power_on(chart)) {}

    const std::vector<Id<Chart::Variable>>& inputs() const { return inputs_; }

    /// Time that passes before the first scan is before power-on.
    void wait(std::int64_t milliseconds);

    /// Executes one scan with `values` in the order of the inputs; returns the fault that stops the PLC, or an empty
    /// string.
    std::string scan(const std::vector<std::int64_t>& values);

    /// As last written.
    std::vector<std::int64_t> outputs() const;
    const State& state() const { return state_; }

private:
    const Chart& chart_;
    ExecutionMode mode_;
    State state_;
    std::vector<Id<Chart::Variable>> inputs_ = variables_of_kind(chart_, Chart::VariableKind::Input);
    std::vector<Id<Chart::Variable>> outputs_ = variables_of_kind(chart_, Chart::VariableKind::Output);
};

}  // namespace grafverif
