// SPDX-License-Identifier: MIT
// An analysis as text, as JSON and as SARIF.
//
// Text: each finding as a diagnostic at its place, then the run that shows it; accepted ones in one line each; then what is
// not decided, and how far it was looked into.
// JSON: `{"chart","mode","complete","obstacle","instants","seconds","questions","open":[{"code","subject","instants",
// "evolutions"}],"notes","findings":[{"code","level","subject",
// "message","file","line","column","related":[{"message","file","line","column"}],"timing","accepted","shows","trace"}]}`,
// a trace as in report/json.hpp; what there is not is null.
// SARIF 2.1.0 (OASIS): one run; a rule per code, a result per finding, whose message ends in the run as a list of inputs
// and whose code flow has a location per finding and related place; accepted ones are suppressed in source. What is not
// decided is a notification of the invocation each.
#pragma once

#include <iosfwd>
#include <string>

#include "grafverif/ir/finding.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

void print_findings(const Analysis& analysis, const Sources& sources, Colour colour, std::ostream& out);
void print_findings_json(const Analysis& analysis, const Sources& sources, std::ostream& out);
/// `version`: of the program, for the record.
void print_findings_sarif(const Analysis& analysis, const Sources& sources, const std::string& version,
                          std::ostream& out);

/// How far a question that is not decided was looked into: `none in the first 9 instants`.
std::string open_text(const OpenQuestion& question);

/// The inputs of a run, change by change: `START at 0 s; !START, V_IN at 5 s`.
std::string inputs_text(const ChartRun& run);

}  // namespace grafverif
