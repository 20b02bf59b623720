// SPDX-License-Identifier: MIT
// Replays a run of the transition system of a program on the interpreter. The replay confirms the run and determines
// the values of all variables.
#pragma once

#include <optional>
#include <string>

#include "grafverif/ir/chart_run.hpp"
#include "ir/flat_system.hpp"
#include "read/program/properties.hpp"
#include "schedule/program/program.hpp"

namespace grafverif {

struct ProgramReplay {
    std::string disagreement = {};  ///< first difference from `run`; empty if the replay confirms the run
    ChartRun trace = {};
    std::optional<ProgramFault> fault = {};  ///< the run-time fault that ends the run; empty if no fault ends it
};

/// Replays `run`. The last scan must violate `property` or, if the property requires a reachable condition, satisfy it.
/// If `property` is null, a run-time fault must occur in the last scan.
ProgramReplay replay_program(const Program& program, const Scan& scan, const ProgramSystem& system,
                             const SystemRun& run, const ProgramProperty* property);

}  // namespace grafverif
