// SPDX-License-Identifier: MIT
// Decision step shared by `check` and `report`: the options select a loop or a chart, its model and an engine; the
// engine decides the properties.
#pragma once

#include <optional>

#include "app/command_context.hpp"
#include "grafverif/ir/why.hpp"

namespace grafverif::app {

struct Decided {
    Report report = {};
    Id<ClosedLoop> loop = {};  ///< not valid: a chart alone
    Id<Chart> chart = {};      ///< valid of a chart alone
    bool timed = false;
    std::optional<ProofExplanation> why = {};  ///< if requested, of a loop
};
/// Nothing after an error. `witnesses`: also return runs of properties that hold. For a chart alone, a notice is first
/// written to `streams`.
std::optional<Decided> decide(const Model& model, CommandContext& job, ResourceLimits& bounds, bool witnesses,
                              const Streams& streams);

/// The exit code that the verdicts of a report imply.
ExitCode exit_code(const Report& report, bool stopped);

}  // namespace grafverif::app
