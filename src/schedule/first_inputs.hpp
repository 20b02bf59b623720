// SPDX-License-Identifier: MIT
// What the first evolution reads. It is no cycle: the inputs it reads are not those that the first cycle samples.
#pragma once

#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif::schedule {

/// Per variable whether the first evolution reads it, once initial values are put in their places: in a stored value
/// or, where outputs are written in every cycle, in an output.
std::vector<bool> read_at_first(const Equations& equations, ExecutionMode mode);

}  // namespace grafverif::schedule
