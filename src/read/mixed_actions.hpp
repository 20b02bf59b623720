// SPDX-License-Identifier: MIT
// Splits outputs that have both continuous and stored actions. IEC 60848 forbids this combination of actions, but other
// formats allow the combination. The stored actions act on a new variable, and the output is true if a continuous
// action or this variable is true. In Sequential Function Charts, the qualifiers N and S on one variable have this
// meaning. For other formats, the conversion is an interpretation, and a warning reports it.
#pragma once

#include "read/draft.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

void split_mixed_actions(Draft& draft, tree::Chart& chart);

}  // namespace grafverif
