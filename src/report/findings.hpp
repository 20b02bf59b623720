// SPDX-License-Identifier: MIT
// Writes the results of `analyse` as text and as JSON; for SARIF see report/sarif.hpp.
//
// The text contains each finding as a diagnostic at its position, followed by a run as evidence. Accepted findings have
// one line each. The text ends with the undecided checks and the number of explored instants of the chart.
//
// JSON: missing values are null; a trace has the format of report/json.hpp. Findings about absorbing regions
// (situations that no run leaves) also have the member `lost`.
//
//   {"chart", "mode", "complete", "obstacle", "instants", "seconds", "questions", "open":[OPEN], "notes",
//   "findings":[FINDING]}
//   OPEN     {"code", "subject", "instants", "evolutions"}
//   FINDING  {"code", "level", "subject", "message", "file", "line", "column", "related":[{"message", "file", "line",
//            "column"}], "timing", "accepted", "shows", "trace"}
#pragma once

#include <iosfwd>
#include <string>

#include "grafverif/ir/finding.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

void print_findings(const Analysis& analysis, const Sources& sources, Colour colour, std::ostream& out);
void print_findings_json(const Analysis& analysis, const Sources& sources, std::ostream& out);

/// Returns the extent of the search for an undecided check, such as `not found in the first 9 instants`.
std::string open_text(const OpenQuestion& question);

/// Returns the inputs of a run, change by change, such as `START at 0 s; !START, V_IN at 5 s`.
std::string inputs_text(const ChartRun& run);

}  // namespace grafverif
