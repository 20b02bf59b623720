// SPDX-License-Identifier: MIT
// Charts from text, executed cycle by cycle by the interpreter, with inputs by name and states as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "derive/derive.hpp"
#include "grafverif/ir/chart.hpp"
#include "run/interpreter.hpp"

namespace grafverif {

/// The only chart of `text`, which is written without its frame: the declarations of a grafcet. Fails the test, with
/// the rendered diagnostics, if it is invalid.
Chart chart(std::string_view text);

/// The equations of chart(text). Fails the test if derive rejects it, or computes malformed ones.
Equations equations(std::string_view text);

/// The messages of derive for a chart that it rejects, each with its code: `[output-cycle] the output ...`.
std::vector<std::string> refusals(std::string_view text);

struct Play {
    Chart chart = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    State state = {};
};

Play play(std::string_view text, ExecutionMode mode = ExecutionMode::StabilitySearch);

/// Executes one cycle with the named inputs true (`a b`; integers as `level=2`), all others false or 0.
Cycle run(Play& play, std::string_view inputs = {});
void wait(Play& play, std::int64_t milliseconds);

/// Names of the active steps, in order: `1 4`.
std::string situation(const Play& play);
/// Names of the outputs that are written true, integers as `SPEED=2`.
std::string outputs(const Play& play);
std::int64_t value(const Play& play, std::string_view variable);
/// Names of the transitions cleared, with evolutions separated by `;`: `t0 t1; t2; `.
std::string fired(const Play& play, const Cycle& cycle);

}  // namespace grafverif
