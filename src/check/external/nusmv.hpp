// SPDX-License-Identifier: MIT
// Interface to NuSMV and nuXmv: generates commands for these programs and reads their results. The caller writes the
// model, runs the program and passes its output to read_nusmv.
//
// The commands print a marker before they check a property by its name, so that each result in the output is assigned
// to its property. The exit code of the program is ignored, because it is 0 even if a property is false. For `reachable
// p`, the negation is checked, and a counterexample of the negation is the witness.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/verdict.hpp"
#include "ir/flat_system.hpp"
#include "support/program.hpp"

namespace grafverif {

/// Returns the commands for `NuSMV -source FILE`. `model` is the path of the model; `properties` contains the indices
/// of the properties to check.
std::string nusmv_commands(const std::string& model, const SystemSpelling& spelling,
                           const std::vector<std::size_t>& properties);

struct NusmvResult {
    std::vector<Verdict> verdicts = {};               ///< verdicts in the order of `properties`
    std::vector<std::optional<SystemRun>> runs = {};  ///< run of each verdict
    std::string states = {};                          ///< number of states, in decimal; empty if NuSMV does not print
                                                      ///< the exact number
    bool total = false;  ///< true if NuSMV has proved that each reachable state has a successor
};

/// Reads the results of the commands of nusmv_commands for the properties of `system`. If the program has no result for
/// a property, the verdict on this property is unknown (`failed` or `stopped`); if the model is not total, all verdicts
/// are unknown. The verdict is also unknown (`engine-disagrees`) in two cases: the program reports a specification as
/// false and its trace is not a run of the system that proves this, or a property has two verdicts.
NusmvResult read_nusmv(const TransitionSystem& system, const SystemSpelling& spelling,
                       const std::vector<std::size_t>& properties, const ProgramResult& program_result);

}  // namespace grafverif
