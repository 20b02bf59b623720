// SPDX-License-Identifier: MIT
// identical_up_to_names: Equations, Equations -> the same tables, entry by entry, apart from positions in the text and
// the names of everything except inputs and outputs. Sufficient for the same behaviour, not necessary.
#pragma once

#include "grafverif/ir/equations.hpp"

namespace grafverif {

bool identical_up_to_names(const Equations& a, const Equations& b);

}  // namespace grafverif
