// SPDX-License-Identifier: MIT
// scan_module: translates a Scan to a module of the TransitionSystem, for the product with another controller. In a
// step in which its parameter `turn` is true, the module executes one scan. In all other steps, no variable of the
// module changes. The module contains only the variables on which outputs and faults depend.
#pragma once

#include <vector>

#include "ir/program/scan.hpp"
#include "schedule/controller_module.hpp"

namespace grafverif::schedule {

/// Returns the module. The flag `race` of the module is set after a run-time fault, and the flag `out_of_range` after a
/// scan in which `stop` was true. Once set, `race` and `out_of_range` remain set. If `out_of_range` is set, a run-time
/// fault in a later scan does not set `race`. `stop` is a term over the values before the scan, or invalid. The symbols
/// `settled` and `faulting` exist only if `settles` is true. `settled` is true if one more scan with the same inputs
/// would change no variable.
ControllerModule scan_module(const Scan& scan, Id<Expr> stop, bool settles, Exprs& exprs);

/// For each variable of the equations: true if an output, a fault or `stop` depends on it.
std::vector<bool> variables_observed(const Scan& scan, Id<Expr> stop);

}  // namespace grafverif::schedule
