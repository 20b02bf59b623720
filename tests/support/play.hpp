// SPDX-License-Identifier: MIT
// Charts from text, and charts played cycle by cycle on the interpreter, with inputs named and states told in words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "derive/derive.hpp"
#include "grafverif/ir/chart.hpp"
#include "run/interpreter.hpp"

namespace grafverif {

/// The one chart of `text`, written without its frame: the declarations of a grafcet. Fails the test, with the rendered
/// diagnostics, where it does not read.
Chart chart(std::string_view text);

/// The equations of chart(text). Fails the test where derive refuses it, or makes ones that are not well formed.
Equations equations(std::string_view text);

/// The messages of derive for a chart that it refuses, each with its code: `[output-cycle] the output ...`.
std::vector<std::string> refusals(std::string_view text);

struct Play {
    Chart chart = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    State state = {};
};

Play play(std::string_view text, ExecutionMode mode = ExecutionMode::StabilitySearch);

/// Makes one cycle with the named inputs true (`a b`; integers as `level=2`), all others false or 0.
Cycle run(Play& play, std::string_view inputs = {});
void wait(Play& play, std::int64_t milliseconds);

/// Names of the active steps, in order: `1 4`.
std::string situation(const Play& play);
/// Names of the outputs that are written true, integers as `SPEED=2`.
std::string outputs(const Play& play);
std::int64_t value(const Play& play, std::string_view variable);
/// Names of the transitions fired, evolutions separated by `;`: `t0 t1; t2; `.
std::string fired(const Play& play, const Cycle& cycle);

}  // namespace grafverif
