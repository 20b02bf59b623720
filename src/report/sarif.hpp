// SPDX-License-Identifier: MIT
// SARIF 2.1.0 (OASIS): the results of one invocation, for one or several files, as one run of one tool.
//
// A rule is a kind of finding, a kind of unexpected verdict, or the code of an error; a result is an occurrence at its
// location. The run of an unexpected verdict is a code flow: one location per row of its table, at the element of the
// chart or loop that causes it. An undecided property is a result of kind `open` and a notification. Expected verdicts
// are omitted. File names are those used on the command line.
#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "grafverif/ir/finding.hpp"
#include "grafverif/ir/report.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "report/report_source.hpp"

namespace grafverif {

struct SarifLog {
    using Json = nlohmann::ordered_json;
    Json rules = Json::array(), results = Json::array(), notifications = Json::array();
    bool successful = true;  ///< everything is decided, without internal failures
};

void add_findings(const Analysis& analysis, const Sources& sources, SarifLog& log);
void add_report(const Report& report, const ReportSource& written, SarifLog& log);
/// Adds the errors in the input; `warnings`: warnings too.
void add_diagnostics(const std::vector<Diagnostic>& diagnostics, const Sources& sources, bool warnings, SarifLog& log);

/// `version`: of the program, recorded in the log.
void print_sarif(const SarifLog& log, const std::string& version, std::ostream& out);

}  // namespace grafverif
