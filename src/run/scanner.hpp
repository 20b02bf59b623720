// SPDX-License-Identifier: MIT
// Scanner: executes a chart scan by scan, as a PLC does. In a scan, inputs are read, one cycle is executed (with or
// without stability search, according to the mode), and outputs are written. Time passes between scans.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "run/interpreter.hpp"

namespace grafverif {

/// Returns the variables of one kind in order of declaration.
std::vector<Id<Chart::Variable>> variables_of_kind(const Chart& chart, Chart::VariableKind kind);

/// Returns the text of a situation, such as `{2, 5}`.
std::string situation_text(const Chart& chart, const std::vector<bool>& situation);

/// Returns the message, with its diagnostic code, for a chart that repeats the situations of `endless` forever.
/// `endless` must not be empty.
std::string instability_text(const Chart& chart, const std::vector<std::vector<bool>>& endless);
/// Returns the message for stored actions that assign different values to `variable`. If `variable` is empty, returns
/// the message for contradictory forcing orders.
std::string race_text(std::string_view variable);

/// Returns the reason why a PLC cannot execute `cycle`, or an empty string if a PLC can execute it.
std::string problem_in(const Chart& chart, const Cycle& cycle);

class Scanner {
public:
    /// `chart` must outlive the scanner.
    Scanner(const Chart& chart, ExecutionMode mode) : chart_(chart), mode_(mode), state_(power_on(chart)) {}

    const std::vector<Id<Chart::Variable>>& inputs() const { return inputs_; }

    /// Advances the time. Time that passes before the first scan is treated as time before power-on.
    void wait(std::int64_t milliseconds);

    /// Executes one scan. `values` contains the values of the inputs, in order. Returns the fault that stops the PLC,
    /// or an empty string.
    std::string scan(const std::vector<std::int64_t>& values);

    /// Returns the last written values of the outputs.
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
