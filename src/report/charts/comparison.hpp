// SPDX-License-Identifier: MIT
// A comparison as text and as JSON.
//
// Text: the verdict and what it rests on; where the charts differ the scans that tell them apart, with what both do in each;
// then the changes of the text.
// JSON: `{"charts":[a,b],"mode","from":[a,b],"resolution_ms","constrained","outcome","reason","shortest","seconds","scans":[
// {"wait_ms","time_ms","inputs":{name:value},"answers":[{"outputs":{name:value},"situation","stop"}, ...]}],"changes":[{"kind",
// "subject","before","after"}]}`; what there is not is null.
#pragma once

#include <iosfwd>
#include <string>

#include "grafverif/ir/comparison.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Without what the texts say.
void print_answer(const Comparison& comparison, Colour colour, std::ostream& out);
void print_comparison(const Comparison& comparison, Colour colour, std::ostream& out);
std::string comparison_json(const Comparison& comparison);

/// The changes of a text, a line each, or two where there is a before and an after.
void print_changes(const std::vector<ChartChange>& changes, std::ostream& out);

}  // namespace grafverif
