// SPDX-License-Identifier: MIT
// simultaneous: executes assignments simultaneously, although a Network executes them sequentially. A term that occurs
// repeatedly is computed once, in a scratch variable. Therefore the size of the result is linear in the number of
// distinct terms, also for engines and targets that expand shared terms.
#pragma once

#include <string>
#include <vector>

#include "compose/controller.hpp"

namespace grafverif {

/// Returns assignments with the effect that all `updates` are executed simultaneously: all values are computed before
/// the first target changes. Each target must occur only once. Every term must have a value (no overflow, no division
/// by zero) in every state. A shared term is computed even if the conditional that contains it does not select it. The
/// names of scratch variables begin with `prefix`.
std::vector<Network::Assignment> simultaneous(Composition& composition, const std::vector<Network::Assignment>& updates,
                                              const std::string& prefix);

}  // namespace grafverif
