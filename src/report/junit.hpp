// SPDX-License-Identifier: MIT
// A Report as JUnit XML, for build servers: a suite per model and a case per property, with its file and line.
//
// A verdict against expectation is a failure: its message begins with the verdict and its place, the first lines of the
// trace follow; its text is the whole trace. One that is not decided is an error, or skipped where the model does not ask.
// What keeps a file from being read or checked is an error of a case of its own, `input`.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "report/report.hpp"
#include "report/written.hpp"

namespace grafverif {

/// `<testsuite>...</testsuite>`, its lines indented.
std::string junit_suite(const Report& report, const Written& written);
/// Of a file with errors.
std::string junit_suite(std::string_view file, const std::vector<Diagnostic>& diagnostics, const Sources& sources);
/// Of a file about which nothing is known; `message` says why.
std::string junit_suite(std::string_view file, std::string_view type, std::string_view message);

/// Something that was expected on a line of a file.
struct JunitCase {
    std::string name = {};
    std::uint32_t line = 0;
    std::string failure = {};  ///< empty: it was met
};
/// Of a script; `ended`: why it stopped before its end, or empty.
std::string junit_suite(std::string_view file, const std::vector<JunitCase>& cases, std::string_view ended);

/// A document of suites.
std::string junit_document(std::string_view suites);

}  // namespace grafverif
