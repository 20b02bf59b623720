// SPDX-License-Identifier: MIT
// Engines of others, from the PATH. Nothing after an error: the program is not there.
#pragma once

#include <optional>
#include <string>

#include "grafverif/ir/report.hpp"
#include "pipeline/check.hpp"

namespace grafverif::app {

/// `verifyta`, on the UPPAAL project of the loop: verdicts, no runs.
std::optional<Report> check_by_verifyta(const LoopToCheck& loop, const CheckOptions& check, Diagnostics& diagnostics);

/// `NuSMV` or `nuXmv`, on the model we write.
std::optional<Report> check_by_nusmv(const SystemToCheck& check, const std::string& program,
                                     const CheckOptions& options, Diagnostics& diagnostics);

}  // namespace grafverif::app
