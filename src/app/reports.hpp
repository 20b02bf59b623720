// SPDX-License-Identifier: MIT
// Report files of a run: each belongs to the run that requested it, or does not exist. Before any work, an old JUnit or
// SARIF report is replaced by one that states that the run did not finish. Other old reports (traces, pages, findings)
// are removed, so that no report of an earlier run remains if this run is killed. After the work the reports are
// written, also after errors. Until the inputs of a run are known, only missing files and reports are modified: a chart
// that was named by mistake is kept.
#pragma once

#include <string>
#include <vector>

#include "app/command_context.hpp"
#include "app/decide.hpp"
#include "app/system/write_files.hpp"
#include "report/sarif.hpp"

namespace grafverif::app {

/// The results of all runs of one invocation.
struct Reports {
    std::string suites = {};  ///< of JUnit
    SarifLog sarif = {};
    std::vector<OutputFile> files = {};  ///< traces
};

/// `output`: the file of `-o` is a report too.
void begin_reports(bool output, CommandContext& job);

/// Adds the verdicts of a model to the requested reports.
void note(const Decided& decided, const Model& model, CommandContext& job);
/// Adds the diagnostics of a run; errors also become lines of `--json-lines`.
void note_diagnostics(CommandContext& job, const Streams& streams);

/// `failed`: after errors, which may have prevented a file from being recorded as an input.
bool write_reports(bool failed, CommandContext& job, const Streams& streams);

}  // namespace grafverif::app
