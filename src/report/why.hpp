// SPDX-License-Identifier: MIT
// Writes proof cores as text and as JSON. A proof core lists the elements of the model that the proof of a property
// needs (docs/explanation/why.md).
#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>

#include "grafverif/ir/why.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

/// Sets the owner of each statement to its line, such as `line 7`, or `press.st:7` if the statements belong to several
/// files.
void name_places(ProofExplanation& why, const Sources& sources);

/// Prints the proof cores. If `verbose` is true, edges of the plant that no property needs are listed; otherwise only
/// the number of these edges is printed.
void print_why(const ProofExplanation& why, bool verbose, std::ostream& out);

nlohmann::ordered_json why_json(const ProofExplanation& why);

}  // namespace grafverif
