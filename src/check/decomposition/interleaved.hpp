// SPDX-License-Identifier: MIT
// Compositional checking with the symbolic engine, for systems in which at most one process moves in each step. Each
// property is decided on the independent subsystems ("sub-loops") that it reads. All other subsystems are omitted if
// the omission preserves the verdict (docs/explanation/decomposition.md, "Sub-loops"). The conditions under which an
// omission preserves a verdict are checked only for verdicts that need the omission. If a condition fails or is
// unknown, the complete system is searched.
//
// `no deadlock` is checked for each subsystem, as in compositional checking with the timed engine.
//
// Each verdict names the omitted subsystems and states why they do not affect the verdict. All runs are runs of the
// complete system.
#pragma once

#include "check/symbolic/symbolic.hpp"

namespace grafverif {

/// Checks the properties in the same way as check_symbolic. All subsystems share the memory limit. Requires
/// verify(system).empty().
SymbolicResult check_symbolic_by_parts(const TransitionSystem& system, const SymbolicOptions& options = {});

}  // namespace grafverif
