// SPDX-License-Identifier: MIT
// controller_equations: derives the equations of a PLC program that is a controller of a closed loop.
//
// Time: if the task cycle is a fixed period T (not a range), the scans begin at the times 0, T, 2T, and so on. The
// elapsed time of a timer is read only in scans, and the time between two scans is exactly T. Therefore the elapsed
// time at each scan is the sum of T over the scans since its start, an integer that the scan computes (`advance_timers`
// in derive/program/scan.cpp). The equations need no clocks, and the output of a timer changes in the same scan as in
// the PLC. The clock of the task cycle relates the times of the scans to the plant. If the time between two scans
// varies, the elapsed time is a real number that the equations cannot represent; in this case, a program with timers is
// rejected.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "ir/program/program.hpp"

namespace grafverif {

/// A program as a controller of a loop.
struct ProgramController {
    std::string name = {};
    /// Task cycle; if empty, the cycle time is zero.
    std::optional<TaskCycle> cycle = {};
    /// The internal variables that properties read. Another internal variable has an equation only if an output, a
    /// step, a fault or an observed variable depends on it. Exception: without a task cycle, or if `reads_stable` is
    /// true, all internal variables have equations. In these cases, `Equations::stable` affects the behaviour or a
    /// verdict, and must not depend on the selection of properties.
    std::vector<Id<Equations::Variable>> observed = {};
    bool reads_stable = false;  ///< true if a property is evaluated only in quiescent states
    Span origin = {};
};

/// Returns the equations of `program`, whose variables are those of `interface_of`. The first evolution is the first
/// scan, at power-on, in which no time has elapsed. The condition of each run-time fault is an element of
/// Equations::conflicts. The result is empty after an error.
std::optional<Equations> controller_equations(const Program& program, const ProgramController& controller,
                                              Diagnostics& diagnostics);

}  // namespace grafverif
