// SPDX-License-Identifier: MIT
// An analysis as text and as JSON.
//
// Text: each finding as a diagnostic at its place, then the run that shows it; accepted ones in one line each; then what is
// not decided, and how far it was looked into.
// JSON: `{"chart","mode","complete","obstacle","instants","seconds","questions","open":[{"code","subject","instants",
// "evolutions"}],"notes","findings":[{"code","level","subject",
// "message","file","line","column","related":[{"message","file","line","column"}],"lost" (of traps),"timing",
// "accepted","shows","trace"}]}`,
// a trace as in report/json.hpp; what there is not is null.
// SARIF: report/sarif.hpp.
#pragma once

#include <iosfwd>
#include <string>

#include "grafverif/ir/finding.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

void print_findings(const Analysis& analysis, const Sources& sources, Colour colour, std::ostream& out);
void print_findings_json(const Analysis& analysis, const Sources& sources, std::ostream& out);

/// How far a question that is not decided was looked into: `none in the first 9 instants`.
std::string open_text(const OpenQuestion& question);

/// The inputs of a run, change by change: `START at 0 s; !START, V_IN at 5 s`.
std::string inputs_text(const ChartRun& run);

}  // namespace grafverif
