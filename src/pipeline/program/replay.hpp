// SPDX-License-Identifier: MIT
// Replays a run of the system of a program on the interpreter. The replay confirms the run and determines the values of
// all variables.
#pragma once

#include <optional>
#include <string>

#include "grafverif/ir/chart_run.hpp"
#include "ir/flat_system.hpp"
#include "read/program/properties.hpp"
#include "schedule/program/program.hpp"

namespace grafverif {

struct ProgramReplay {
    std::string disagreement = {};  ///< difference from the run of the system; empty if the run is confirmed
    ChartRun trace = {};
    std::optional<ProgramFault> fault = {};  ///< the fault that ends the run; empty if no fault ends it
};

/// Replays `run`. The last scan must violate `property` or, for `reachable`, satisfy it. If `property` is null, the
/// last scan must have a fault.
ProgramReplay replay_program(const Program& program, const Scan& scan, const ProgramSystem& system,
                             const SystemRun& run, const ProgramProperty* property);

}  // namespace grafverif
