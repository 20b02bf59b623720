// SPDX-License-Identifier: MIT
// mutants: the tree of a file -> plausible mistakes in one of its charts, one at a time, each as the text of the whole file in
// canonical form, so that it is read like any other.
//
//   term-dropped        one operand of an `and` or `or` is missing
//   term-negated        one operand, or a whole condition, is negated; of a negation the `not` is missing
//   and-or              `and` for `or`, and the other way
//   and-divergence      the branches of a parallel divergence are alternatives
//   or-divergence       two alternatives of one step are parallel branches, under the condition of the first
//   wrong-successor     a transition leads to another step of its partial chart
//   duration            a duration is twice as long
//   action-missing      an action is not there
//   output-swapped      a continuous action sets another output
//   stored-side         a stored action runs on deactivation, not on activation, and the other way
//   forcing-missing     a forcing order is not there
//   not-initial         an initial step is not one, where there are several
#pragma once

#include <string_view>
#include <vector>

#include "ir/mutation.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

/// In the order of the declarations. No two have one text, and none that of the file. Requires a file that is not broken, with
/// a chart of this name in it; else there are none.
std::vector<Mutant> mutants(const tree::File& file, std::string_view chart);

}  // namespace grafverif
