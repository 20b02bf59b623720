// SPDX-License-Identifier: MIT
// identical_up_to_names: true if two Equations have the same tables, entry by entry. Positions in the text are ignored.
// Names are also ignored, except for the names of inputs and outputs. This condition is sufficient for equal behaviour,
// but not necessary.
#pragma once

#include "grafverif/ir/equations.hpp"

namespace grafverif {

bool identical_up_to_names(const Equations& a, const Equations& b);

}  // namespace grafverif
