// SPDX-License-Identifier: MIT
// A report as JUnit XML for build servers: a test case per property, named by it. A verdict against expectation and
// a place where the model breaks off are failures, with the trace as their text; an unknown verdict is an error,
// unless the model does not ask for it: then it is skipped.
#pragma once

#include <iosfwd>

#include "report/report.hpp"

namespace grafverif {

void print_junit(const Report& report, std::ostream& out);

}  // namespace grafverif
