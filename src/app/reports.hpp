// SPDX-License-Identifier: MIT
// Report files of an invocation. No report of an earlier invocation remains, even if this invocation is killed. Before
// any work, an old JUnit or SARIF report is replaced by a report that states that the run did not finish. Other old
// reports (traces, pages, findings) are removed. The reports are written after the work, also after errors. Until the
// inputs are known, no existing file is modified except old reports. Therefore a chart is not overwritten if the user
// names it as a report by mistake.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/command_context.hpp"
#include "app/decide.hpp"
#include "app/system/write_files.hpp"
#include "page/page.hpp"
#include "report/sarif.hpp"

namespace grafverif::app {

/// The results of all executions of one invocation.
struct Reports {
    std::string suites = {};  ///< text of the test suites in the JUnit report
    SarifLog sarif = {};
    std::vector<OutputFile> files = {};  ///< trace files to be written
};

/// Returns `content` as an HTML report with the file, the options and the warnings of the command.
std::string report_page(PageContent content, const CommandContext& job);

/// Returns the content of the HTML report about `decided`, except the verdicts: the drawings and analyses of the
/// charts, and the summary of the certificate. `chart` is the chart of the report if `decided` is not about a loop.
/// Returns nothing after an error.
std::optional<PageContent> verdict_content(const Model& model, const Decided& decided, Id<Chart> chart,
                                           CommandContext& job, const ResourceLimits& bounds);
/// True if the analysis of a chart has an internal error.
bool has_failed(const PageContent& content);

/// Prepares the report files. `output` is true if the file given by `-o` is also a report.
void begin_reports(bool output, CommandContext& job);

/// Adds the verdicts of a model to the requested reports.
void note(const Decided& decided, const Model& model, CommandContext& job);
/// Adds the diagnostics of a run; errors also become lines of `--json-lines`.
void note_diagnostics(CommandContext& job, const Streams& streams);

/// Writes the reports. `failed` is true after errors, which may have prevented a file from being recorded as an input.
bool write_reports(bool failed, CommandContext& job, const Streams& streams);

}  // namespace grafverif::app
