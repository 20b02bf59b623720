// SPDX-License-Identifier: MIT
// What became of mutants, as text and as JSON.
//
// Text: how many there are of each fate, the scores of the specification and of the tests, how many each property notices, then
// each that no property notices as a change of the text, and what was not decided.
// JSON: `{"chart","possible","properties":[{"name","notices"}],"test_steps","no_test","counts":{fate:number,"not_judged"},
// "specification":{"notices","of"},"tests":{"catch","of"},"mutants":[{"kind","subject","file","line","before","after","fate",
// "reason","noticed_by","undecided","caught","scans"}]}`; what there is not is null.
#pragma once

#include <iosfwd>
#include <string>

#include "grafverif/support/source.hpp"
#include "ir/mutation.hpp"

namespace grafverif {

void print_mutation(const Mutation& mutation, const Sources& sources, std::ostream& out);
std::string mutation_json(const Mutation& mutation, const Sources& sources);

}  // namespace grafverif
