// SPDX-License-Identifier: MIT
// A report as JSON: `{"model","properties":[{"name","text","verdict","expected","engine","mode","grain","states",
// "transitions","seconds","reason","vacuous","notes","trace"}]}`, and `"errors":[{"code","message","trace"}]` where the
// model breaks off, and `"profile"` (report/profile.hpp) where there is one. A trace is `{"loop_from","steps":[{"time","kind","component","inputs","fired","situation",
// "outputs","moment"}],"run"}`; time is in milliseconds, inputs and outputs are objects by name, all of them in every
// step; `run` is all that there is to know of the run (docs/trace.md). What there is not is null.
#pragma once

#include <iosfwd>

#include "report/report.hpp"

namespace grafverif {

void print_json(const Report& report, std::ostream& out);

}  // namespace grafverif
