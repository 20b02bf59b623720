// SPDX-License-Identifier: MIT
// Decision step shared by `check` and `report`: the options select a loop or a chart, its model and an engine; the
// engine decides the properties.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "app/command_context.hpp"
#include "grafverif/ir/why.hpp"
#include "pipeline/certificate/certificate.hpp"
#include "report/remedies/trials.hpp"

namespace grafverif::app {

struct Decided {
    Report report = {};
    std::vector<Trial> trials = {};  ///< checks with other options (remedies), if a limit ended the check
    Id<ClosedLoop> loop = {};        ///< the loop; invalid for a chart without a loop
    Id<Chart> chart = {};            ///< the chart, if it was checked without a loop; otherwise invalid
    bool timed = false;
    std::optional<Certificate> certificate = {};  ///< certificate of a timed check, if requested
    std::optional<ProofExplanation> why = {};     ///< proof explanation of a loop, if requested
};

/// Decides the properties. Returns nothing after an error. If `witnesses` is true, runs of properties that hold are
/// also returned. For a chart without a loop, a note is first written to `streams`.
std::optional<Decided> decide(const Model& model, CommandContext& job, ResourceLimits& bounds, bool witnesses,
                              const Streams& streams);

/// Decides the properties of a PLC program with the property file of the options. Returns the verdicts and a model
/// whose only chart represents the program, or nothing after an error.
std::optional<std::pair<Model, Decided>> decide_program(CommandContext& job, ResourceLimits& bounds, bool witnesses);

/// Returns the exit code that the verdicts of a report imply.
ExitCode exit_code(const Report& report, bool stopped);

}  // namespace grafverif::app
