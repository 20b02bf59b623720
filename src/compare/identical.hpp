// SPDX-License-Identifier: MIT
// identical_up_to_names: true if two Equations have the same tables, entry by entry. Positions in the text are ignored,
// and so are all names except those of inputs and outputs. This is sufficient for the same behaviour, but not
// necessary.
#pragma once

#include "grafverif/ir/equations.hpp"

namespace grafverif {

bool identical_up_to_names(const Equations& a, const Equations& b);

}  // namespace grafverif
