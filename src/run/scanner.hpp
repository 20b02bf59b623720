// SPDX-License-Identifier: MIT
// Scanner: a chart run as a PLC runs it, scan by scan: inputs are read, the whole stability search is made if the mode has
// one, outputs are written; time passes in between.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "run/interpreter.hpp"

namespace grafverif {

/// In the order of their declaration.
std::vector<Id<Chart::Variable>> variables_of_kind(const Chart& chart, Chart::VariableKind kind);

/// `{2, 5}`
std::string situation_text(const Chart& chart, const std::vector<bool>& situation);

/// What is wrong where a chart goes through the situations of `endless`, at least one, for ever; with its code.
std::string instability_text(const Chart& chart, const std::vector<std::vector<bool>>& endless);
/// What is wrong where stored actions give `variable` different values; empty: where forcing orders contradict each other.
std::string race_text(std::string_view variable);

/// Why `cycle` is none that a PLC can make; empty: it is one.
std::string problem_in(const Chart& chart, const Cycle& cycle);

class Scanner {
public:
    /// `chart` outlives it.
    Scanner(const Chart& chart, ExecutionMode mode) : chart_(chart), mode_(mode), state_(power_on(chart)) {}

    const std::vector<Id<Chart::Variable>>& inputs() const { return inputs_; }

    /// Time that passes before the first scan is before power-on.
    void wait(std::int64_t milliseconds);

    /// One scan, of `values` in the order of the inputs; what stops the PLC, or nothing.
    std::string scan(const std::vector<std::int64_t>& values);

    /// As they were written last.
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
