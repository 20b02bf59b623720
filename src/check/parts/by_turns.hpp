// SPDX-License-Identifier: MIT
// The symbolic engine by sub-loops, where one process moves in a step: each property is decided on the sub-loops that it
// reads, without the others, wherever that gives the verdict of the whole (docs/engines.md, "Sub-loops"). What the others
// must be for that is asked of them when it matters; where it fails or stays unknown, the whole is searched.
//
// `no deadlock` is judged of each sub-loop by itself, as by the timed engine.
//
// Every verdict says what was left out and why. Runs are runs of the whole.
#pragma once

#include "check/symbolic/symbolic.hpp"

namespace grafverif {

/// As check_symbolic; the memory allowed is for all sub-loops together. Requires verify(system).empty().
SymbolicResult check_symbolic_by_parts(const TransitionSystem& system, const SymbolicOptions& options = {});

}  // namespace grafverif
