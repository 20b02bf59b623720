// SPDX-License-Identifier: MIT
// A report as JSON: `{"model","properties":[{"name","text","file","line","column","verdict","expected","declared","engine","mode","grain",
// "states","transitions","seconds","reason","vacuous","notes","trace"}]}`, and `"errors":[{"code","message","trace"}]` where the
// model breaks off, `"profile"` (report/profile.hpp) and `"why"` (report/why.hpp) where there is one. A trace is `{"loop_from","steps":[{"time","kind","component","inputs","fired","situation",
// "outputs","moment"}],"run"}`; time is in milliseconds, inputs and outputs are objects by name, all of them in every
// step; `run` is all that there is to know of the run (docs/trace.md). What there is not is null.
//
// As JSON lines: an object per verdict and line, `{"file","line","column","model","property","text","verdict","expected",
// "declared","as_expected","engine","mode","grain","states","seconds","reason","vacuous","notes","story"}`: of a verdict against
// expectation `story` is the table of its trace, line by line. Where the model breaks off and of an error in the input
// `verdict` is `error`, with `code` and `message`.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "grafverif/ir/why.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "report/report.hpp"
#include "report/written.hpp"

namespace grafverif {

/// `sources`: of the model; without them the report says of no place.
void print_json(const Report& report, const Sources& sources, std::ostream& out, const Why* why = nullptr);
void print_json_lines(const Report& report, const Written& written, std::ostream& out);
/// Of the errors among `diagnostics`; `file`: the one that was to be checked.
void print_json_lines(const std::string& file, const std::vector<Diagnostic>& diagnostics, const Sources& sources,
                      std::ostream& out);

}  // namespace grafverif
