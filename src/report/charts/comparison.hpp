// SPDX-License-Identifier: MIT
// Writes a comparison as text and as JSON.
//
// The text contains the verdict and its assumptions. If the charts differ, the text then lists the distinguishing scans
// with the outputs of both charts. The text ends with the differences between the source texts of the two charts.
//
// JSON: missing values are null.
//
//   {"charts":[a, b], "programs":[a, b], "mode", "settled", "from":[a, b], "resolution_ms", "interval_ms",
//   "constrained", "restricted":[name], "ignored":[name], "stop_outputs":[a, b], "outcome", "reason", "faulty",
//   "shortest", "seconds", "scans":[SCAN], "changes":[{"kind", "subject", "before", "after"}]}
//   SCAN  {"wait_ms", "time_ms", "inputs":{name:value}, "answers":[{"outputs":{name:value}, "situation", "stop"}, ...]}
#pragma once

#include <iosfwd>
#include <string>

#include "grafverif/ir/comparison.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Prints the result without the differences between the texts of the charts.
void print_result(const Comparison& comparison, Colour colour, std::ostream& out);
void print_comparison(const Comparison& comparison, Colour colour, std::ostream& out);
std::string comparison_json(const Comparison& comparison);

/// Prints the changes of a text: two lines for a changed element, and one line for any other change.
void print_changes(const std::vector<ChartChange>& changes, std::ostream& out);

}  // namespace grafverif
