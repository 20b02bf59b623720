// SPDX-License-Identifier: MIT
// Proof cores of properties that hold, as text and as JSON (docs/explanation/why.md).
#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>

#include "grafverif/ir/why.hpp"

namespace grafverif {

/// `verbose`: lists edges of the plant that no property needs, instead of only counting them.
void print_why(const ProofExplanation& why, bool verbose, std::ostream& out);

nlohmann::ordered_json why_json(const ProofExplanation& why);

}  // namespace grafverif
