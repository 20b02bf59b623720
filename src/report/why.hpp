// SPDX-License-Identifier: MIT
// What properties that hold rest on, for people and for programs (docs/why.md).
#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>

#include "grafverif/ir/why.hpp"

namespace grafverif {

/// `verbose`: edges of the plant that no property needs are named, not counted alone.
void print_why(const Why& why, bool verbose, std::ostream& out);

nlohmann::ordered_json why_json(const Why& why);

}  // namespace grafverif
