// SPDX-License-Identifier: MIT
// Splits outputs that have both continuous and stored actions. IEC 60848 forbids such outputs, but other formats allow
// them. The stored actions act on a new variable, and the output is true if a continuous action or this variable is
// true. In Sequential Function Charts, the qualifier N together with S has this meaning. For other formats, this
// conversion is an interpretation, which a warning reports.
#pragma once

#include "read/draft.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

void split_mixed_actions(Draft& draft, tree::Chart& chart);

}  // namespace grafverif
