// SPDX-License-Identifier: MIT
// Reports are of the run that was asked for them, or they are not there. Before any work an old JUnit or SARIF report is
// replaced by one that says that the run did not come to its end, and other old reports (traces, pages, findings) are
// removed: whatever ends the run, no report of an earlier one stands. After the work, errors included, the reports are
// written. Until it is known what a run reads, only what is missing or is a report is touched: a file named by mistake,
// a chart, stays.
#pragma once

#include <string>
#include <vector>

#include "app/decide.hpp"
#include "app/job.hpp"
#include "app/system/write_files.hpp"
#include "report/sarif.hpp"

namespace grafverif::app {

/// What the runs of one call found.
struct Reports {
    std::string suites = {};  ///< of JUnit
    SarifLog sarif = {};
    std::vector<OutputFile> files = {};  ///< traces
};

/// `output`: what `-o` names is a report too.
void begin_reports(bool output, Job& job);

/// What was decided of the model, for the reports that are asked for.
void note(const Decided& decided, const Model& model, Job& job);
/// What the diagnostics of a run say; of errors also the lines of `--json-lines`.
void note_diagnostics(Job& job, const Streams& streams);

/// `failed`: after errors, which may have kept a file from being known as one that is read.
bool write_reports(bool failed, Job& job, const Streams& streams);

}  // namespace grafverif::app
