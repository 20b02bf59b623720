// SPDX-License-Identifier: MIT
// Scanner: executes a chart scan by scan, as a PLC does. In a scan, inputs are read, one cycle is executed (with
// stability search, depending on the mode), and outputs are written. Time passes between scans.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "run/interpreter.hpp"

namespace grafverif {

/// Returns the variables of one kind in order of declaration.
std::vector<Id<Chart::Variable>> variables_of_kind(const Chart& chart, Chart::VariableKind kind);

/// Returns a situation such as `{2, 5}`.
std::string situation_text(const Chart& chart, const std::vector<bool>& situation);

/// Returns the message, with its code, for a chart that repeats the situations of `endless` forever. `endless` must not
/// be empty.
std::string instability_text(const Chart& chart, const std::vector<std::vector<bool>>& endless);
/// Returns the message for stored actions that assign different values to `variable`; if the name is empty, the message
/// for contradictory forcing orders.
std::string race_text(std::string_view variable);

/// Returns the reason why a PLC cannot execute `cycle`, or an empty string if it can.
std::string problem_in(const Chart& chart, const Cycle& cycle);

class Scanner {
public:
    /// `chart` must outlive the scanner.
    Scanner(const Chart& chart, ExecutionMode mode) : chart_(chart), mode_(mode), state_(power_on(chart)) {}

    const std::vector<Id<Chart::Variable>>& inputs() const { return inputs_; }

    /// Lets time pass. Time that passes before the first scan passes before power-on.
    void wait(std::int64_t milliseconds);

    /// Executes one scan with `values` in the order of the inputs. Returns the fault that stops the PLC, or an empty
    /// string.
    std::string scan(const std::vector<std::int64_t>& values);

    /// Returns the outputs that were last written.
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
