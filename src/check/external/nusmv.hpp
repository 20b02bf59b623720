// SPDX-License-Identifier: MIT
// NuSMV and nuXmv as engines: what they are told, and what their answers mean. Whoever calls writes the model, runs the
// program and hands over what it printed.
//
// Each property is asked for by its name, behind a mark of ours, so that the order of answers does not matter; the
// exit code means nothing (it is 0 where a property is false). The model asks `reachable p` as its opposite, whose
// counterexample is the witness.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/verdict.hpp"
#include "ir/flat_system.hpp"
#include "support/program.hpp"

namespace grafverif {

/// The commands for `NuSMV -source FILE`. `model`: the path of the model; `properties`: the indices of those to ask for.
std::string nusmv_commands(const std::string& model, const SystemSpelling& spelling,
                           const std::vector<std::size_t>& properties);

struct NusmvResult {
    std::vector<Verdict> verdicts = {};               ///< in the order of `properties`
    std::vector<std::optional<SystemRun>> runs = {};  ///< per verdict
    std::string states = {};                          ///< in decimal, where NuSMV says it exactly
    bool total = false;                               ///< NuSMV found no reachable state without a step
};

/// What the run of those commands says of the properties of `system`. A verdict is unknown (`failed`) where the program
/// gives none, and everywhere if the model is not total. A specification that is false must come with a run of the system
/// that shows it, and no property with two verdicts; else it is unknown too (`engine-disagrees`).
NusmvResult read_nusmv(const TransitionSystem& system, const SystemSpelling& spelling,
                       const std::vector<std::size_t>& properties, const ProgramResult& said);

}  // namespace grafverif
