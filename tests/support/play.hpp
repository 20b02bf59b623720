// SPDX-License-Identifier: MIT
// Reads charts from text and executes them cycle by cycle with the interpreter. Inputs are given by name, and states
// are compared as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "derive/derive.hpp"
#include "grafverif/ir/chart.hpp"
#include "run/interpreter.hpp"

namespace grafverif {

/// Returns the only chart of `text`, which contains the declarations of a grafcet without the enclosing `grafcet NAME {
/// }`. Fails the test, with the rendered diagnostics, if the chart is invalid.
Chart chart(std::string_view text);

/// Returns the equations of chart(text). Fails the test if derive rejects the chart or computes malformed equations.
Equations equations(std::string_view text);

/// Returns the messages of derive for a chart that it rejects, each with its code: `[output-cycle] the output ...`.
std::vector<std::string> refusals(std::string_view text);

struct Play {
    Chart chart = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    State state = {};
};

Play play(std::string_view text, ExecutionMode mode = ExecutionMode::StabilitySearch);

/// Executes one cycle in which the named inputs are true (`a b`) or have the given values (`level=2`). All other inputs
/// are false or 0.
Cycle run(Play& play, std::string_view inputs = {});
void wait(Play& play, std::int64_t milliseconds);

/// Returns the names of the active steps in order: `1 4`.
std::string situation(const Play& play);
/// Returns the names of the outputs that are written true, with integers as `SPEED=2`.
std::string outputs(const Play& play);
std::int64_t value(const Play& play, std::string_view variable);
/// Returns the names of the transitions cleared, with evolutions separated by `;`: `t0 t1; t2; `.
std::string fired(const Play& play, const Cycle& cycle);

}  // namespace grafverif
