// SPDX-License-Identifier: MIT
// Writes results in the format SARIF 2.1.0 (OASIS). The log has one run of one tool, which contains the results of an
// invocation of grafverif for all its files.
//
// A rule is a type of finding, a type of unexpected verdict, or the code of an error. A result is an occurrence of a
// rule with its position. The counterexample of an unexpected verdict is a code flow. A code flow has one location per
// row of the trace: the element of the chart or loop that causes the row. An undecided property is a result of kind
// `open` and a notification. Expected verdicts are omitted. File names are written as on the command line.
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
    bool successful = true;  ///< true if there are no errors, and every declared property and check is decided
};

void add_findings(const Analysis& analysis, const Sources& sources, SarifLog& log);
void add_report(const Report& report, const ReportSource& written, SarifLog& log);
/// Adds the errors in the input to the log. If `warnings` is true, also adds the warnings.
void add_diagnostics(const std::vector<Diagnostic>& diagnostics, const Sources& sources, bool warnings, SarifLog& log);

/// Prints the log. `version` is the version of the program.
void print_sarif(const SarifLog& log, const std::string& version, std::ostream& out);

}  // namespace grafverif
