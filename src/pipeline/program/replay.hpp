// SPDX-License-Identifier: MIT
// Replays a run of the system of a program on the interpreter, which confirms it and gives the values of all variables.
#pragma once

#include <string>

#include "grafverif/ir/chart_run.hpp"
#include "ir/flat_system.hpp"
#include "read/program/properties.hpp"
#include "schedule/program/program.hpp"

namespace grafverif {

struct ProgramReplay {
    std::string disagreement = {};  ///< with the run of the system; empty: it is confirmed
    ChartRun trace = {};
};

/// `property`: the last scan has to violate it, or for `reachable` to reach it; nullptr: it has to divide by zero.
ProgramReplay replay_program(const Program& program, const Scan& scan, const ProgramSystem& system,
                             const SystemRun& run, const ProgramProperty* property);

}  // namespace grafverif
