// SPDX-License-Identifier: MIT
// Compositional checking with the symbolic engine, for systems in which at most one process moves in each step. Each
// property is decided on the independent subsystems ("sub-loops") that it reads. The other subsystems are omitted if
// this preserves the verdict (docs/explanation/decomposition.md, "Sub-loops"). The side conditions on omitted
// subsystems are checked when a verdict requires them; if a condition fails or is unknown, the complete system is
// searched.
//
// `no deadlock` is checked for each subsystem, as in compositional checking with the timed engine.
//
// Each verdict names the omitted subsystems and states the reason. All runs are runs of the complete system.
#pragma once

#include "check/symbolic/symbolic.hpp"

namespace grafverif {

/// Checks the properties in the same way as check_symbolic. All subsystems share the memory limit. Requires
/// verify(system).empty().
SymbolicResult check_symbolic_by_parts(const TransitionSystem& system, const SymbolicOptions& options = {});

}  // namespace grafverif
