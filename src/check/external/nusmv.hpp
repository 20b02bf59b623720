// SPDX-License-Identifier: MIT
// NuSMV and nuXmv as engines: generates their commands and reads their results. The caller writes the model, runs the
// program and passes its output.
//
// Each property is checked by its name after a printed marker, so that the order of results is irrelevant. The exit
// code is ignored (it is 0 even if a property is false). `reachable p` is checked by its negation, whose counterexample
// is the witness.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/verdict.hpp"
#include "ir/flat_system.hpp"
#include "support/program.hpp"

namespace grafverif {

/// The commands for `NuSMV -source FILE`. `model`: the path of the model; `properties`: the indices of those to check.
std::string nusmv_commands(const std::string& model, const SystemSpelling& spelling,
                           const std::vector<std::size_t>& properties);

struct NusmvResult {
    std::vector<Verdict> verdicts = {};               ///< in the order of `properties`
    std::vector<std::optional<SystemRun>> runs = {};  ///< per verdict
    std::string states = {};                          ///< in decimal, if NuSMV prints it exactly
    bool total = false;                               ///< NuSMV found that each reachable state has a step
};

/// Reads the results of these commands for the properties of `system`. A verdict is unknown (`failed`) if the program
/// has no result for it, and all are if the model is not total. A false specification must come with a run of the
/// system that shows it, and no property may have two verdicts; otherwise it is unknown too (`engine-disagrees`).
NusmvResult read_nusmv(const TransitionSystem& system, const SystemSpelling& spelling,
                       const std::vector<std::size_t>& properties, const ProgramResult& said);

}  // namespace grafverif
