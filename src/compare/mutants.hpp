// SPDX-License-Identifier: MIT
// mutants: creates mutants of a chart of a file. Each mutant has one plausible mistake. A mutant is the text of the
// complete file in canonical form, and can be read like any other file.
//
//   `term-dropped`:    One operand of an `and` or `or` is missing.
//   `term-negated`:    One operand, or a complete condition, is negated; from a negation, the `not` is removed.
//   `and-or`:          The operator `and` replaces `or`, or vice versa.
//   `and-divergence`:  The branches of a parallel divergence become alternatives.
//   `or-divergence`:   Two alternatives of one step become parallel branches, with the condition of the first
//                      alternative.
//   `wrong-successor`: A transition leads to another step of its partial chart.
//   `duration`:        A duration is twice as long.
//   `action-missing`:  An action is missing.
//   `output-swapped`:  A continuous action sets another output.
//   `stored-side`:     A stored action is executed on deactivation instead of activation, or vice versa.
//   `forcing-missing`: A forcing order is missing.
//   `not-initial`:     One of several initial steps is no longer initial.
#pragma once

#include <string_view>
#include <vector>

#include "ir/mutation.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

/// Returns the mutants in the order of the declarations. All texts are distinct and differ from the text of the file.
/// The result is empty if the file has syntax errors (`broken`) or does not contain a chart with this name.
std::vector<Mutant> mutants(const tree::File& file, std::string_view chart);

}  // namespace grafverif
