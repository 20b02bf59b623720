// SPDX-License-Identifier: MIT
// Writes a Report as JUnit XML for build servers: a suite per model and a case per property, with its file and line.
//
// An unexpected verdict is a failure. The message of the failure consists of the verdict, the position of the property
// and the first lines of the trace; the text of the failure is the complete trace. An undecided property is an error,
// or a skipped case if the model does not declare the property. If an error prevents a file from being read or checked,
// a separate case `input` contains this error.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "report/report.hpp"
#include "report/report_source.hpp"

namespace grafverif {

/// Returns `<testsuite>...</testsuite>` with indented lines.
std::string junit_suite(const Report& report, const ReportSource& written);
/// Returns the suite of a file with errors.
std::string junit_suite(std::string_view file, const std::vector<Diagnostic>& diagnostics, const Sources& sources);
/// Returns the suite of a file without results; `message` is the reason.
std::string junit_suite(std::string_view file, std::string_view type, std::string_view message);

/// An expectation in one line of a simulation script, with its result.
struct JunitCase {
    std::string name = {};
    std::uint32_t line = 0;
    std::string failure = {};  ///< description of the failure; empty if the expectation was met
};
/// Returns the suite of a simulation script. `ended` is the reason why the script stopped before its end; empty if the
/// script was completed.
std::string junit_suite(std::string_view file, const std::vector<JunitCase>& cases, std::string_view ended);

/// Returns a document that contains suites.
std::string junit_document(std::string_view suites);

}  // namespace grafverif
