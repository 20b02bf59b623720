// SPDX-License-Identifier: MIT
// identical_up_to_names: compares two Equations; the result is true if they have the same tables, entry by entry.
// Positions in the text are ignored. Names are also ignored, except for the names of inputs and outputs. Equations with
// the same tables have the same behaviour, but different tables can also have the same behaviour.
#pragma once

#include "grafverif/ir/equations.hpp"

namespace grafverif {

bool identical_up_to_names(const Equations& a, const Equations& b);

}  // namespace grafverif
