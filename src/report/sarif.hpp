// SPDX-License-Identifier: MIT
// SARIF 2.1.0 (OASIS): what a call of the program found, of one file or of many, as one run of one tool.
//
// A rule is a kind of finding, a way to be against expectation, or the code of an error; a result is one of them at its
// place. Of a verdict that is not as expected the run that shows it is a code flow: a location per row of its table, each
// where the chart or the loop says what happens there. What is not decided is a result of kind `open` and a notification;
// what is as expected is not told. Places are of the sources as they were named.
#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "grafverif/ir/finding.hpp"
#include "grafverif/ir/report.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "report/written.hpp"

namespace grafverif {

struct SarifLog {
    using Json = nlohmann::ordered_json;
    Json rules = Json::array(), results = Json::array(), notifications = Json::array();
    bool successful = true;  ///< everything is decided, and nothing of ours has failed
};

void add_findings(const Analysis& analysis, const Sources& sources, SarifLog& log);
void add_report(const Report& report, const Written& written, SarifLog& log);
/// What is wrong with the input. `warnings`: those too.
void add_diagnostics(const std::vector<Diagnostic>& diagnostics, const Sources& sources, bool warnings, SarifLog& log);

/// `version`: of the program, for the record.
void print_sarif(const SarifLog& log, const std::string& version, std::ostream& out);

}  // namespace grafverif
