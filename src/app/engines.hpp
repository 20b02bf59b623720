// SPDX-License-Identifier: MIT
// External engines, which are searched for on the PATH. If a program is not found, the function
// that runs this program adds an error and returns an empty result.
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "check/pdr/check.hpp"
#include "grafverif/ir/report.hpp"
#include "pipeline/check.hpp"

namespace grafverif::app {

/// Runs `verifyta` on the UPPAAL project of the loop. The verdicts have no runs.
std::optional<Report> check_by_verifyta(const LoopToCheck& loop, const CheckOptions& check, Diagnostics& diagnostics);

/// Runs `NuSMV` or `nuXmv` on the exported model.
std::optional<Report> check_by_nusmv(const SystemToCheck& check, const std::string& program,
                                     const CheckOptions& options, Diagnostics& diagnostics);

/// Runs ABC (`berkeley-abc`) on the circuit of each property: first `bmc3`, then `pdr`. A proof includes an invariant.
std::optional<Report> check_by_abc(const SystemToCheck& check, const CheckOptions& options, Diagnostics& diagnostics);

/// Returns ABC as a search procedure for check_pdr. `program` is the path of ABC.
decltype(PdrOptions::reach) search_by_abc(std::string program, const std::atomic<bool>* stop);

/// Runs a checker of the hardware model checking competition in the shell as `COMMAND model.aig`.
std::optional<Report> check_by_command(const SystemToCheck& check, const std::string& command,
                                       const CheckOptions& options);

}  // namespace grafverif::app
