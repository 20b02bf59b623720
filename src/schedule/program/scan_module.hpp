// SPDX-License-Identifier: MIT
// scan_module: translates a Scan to a module of the TransitionSystem, for the product with another controller. In a
// step in which its parameter `turn` is true, the module executes one scan; otherwise no variable changes. It contains
// the variables on which outputs and faults depend.
#pragma once

#include <vector>

#include "ir/program/scan.hpp"
#include "schedule/controller_module.hpp"

namespace grafverif::schedule {

/// Returns the module. `race` is set after a run-time fault, and `out_of_range` after a scan in which `stop` was true;
/// both are permanent. A fault in a scan after `out_of_range` was set does not set `race`. `stop` is a term over the
/// values before the scan, or invalid. `settled` (one more scan with the same inputs would change no variable) and
/// `faulting` are defined only if `settles` is true.
ControllerModule scan_module(const Scan& scan, Id<Expr> stop, bool settles, Exprs& exprs);

/// For each variable of the equations: true if an output, a fault or `stop` depends on it.
std::vector<bool> variables_observed(const Scan& scan, Id<Expr> stop);

}  // namespace grafverif::schedule
