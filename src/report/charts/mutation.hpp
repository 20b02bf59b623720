// SPDX-License-Identifier: MIT
// Writes results of mutation testing as text and as JSON.
//
// The text contains the number of mutants with each result, the scores of the specification and of the tests, and the
// number of mutants that each property detects. The text then lists each mutant that no property detects, as a change
// of the source text, and the mutants with unknown result.
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
