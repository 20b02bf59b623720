// SPDX-License-Identifier: MIT
// Results of mutation testing as text and as JSON.
//
// Text: the number of mutants per fate, the scores of the specification and of the tests, and the number of mutants
// that each property detects. Then each mutant that no property detects, as a change of the text, and the unknown ones.
//
// JSON: missing values are null.
//
//   {"chart", "possible", "properties":[{"name", "notices"}], "test_steps", "no_test",
//   "counts":{fate:number, "not_judged"}, "specification":{"notices", "of"}, "tests":{"catch", "of"},
//   "mutants":[MUTANT]}
//   MUTANT  {"kind", "subject", "file", "line", "before", "after", "fate", "reason", "noticed_by", "undecided",
//           "caught", "scans"}
#pragma once

#include <iosfwd>
#include <string>

#include "grafverif/support/source.hpp"
#include "ir/mutation.hpp"

namespace grafverif {

void print_mutation(const Mutation& mutation, const Sources& sources, std::ostream& out);
std::string mutation_json(const Mutation& mutation, const Sources& sources);

}  // namespace grafverif
