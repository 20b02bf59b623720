// SPDX-License-Identifier: MIT
// Parameters that several processes pass variables to have one type: integer variables are widened to the hull of the
// ranges of all that meet in a parameter, directly or through others.
#pragma once

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Widens the integer variables of `network` and sets the types of its Read and Written parameters.
void unify_ranges(Network& network);

}  // namespace grafverif
