// SPDX-License-Identifier: MIT
// Creates the page of `grafverif report` from the report in a Python object.
#pragma once

#include <optional>
#include <string>

#include "grafverif/grafverif.hpp"

namespace grafverif::python {

/// Returns the page of a report about `loop`, or about `chart` if `loop` is invalid; empty after an error.
std::optional<std::string> report_page(const ParseResult& reading, Id<ClosedLoop> loop, Id<Chart> chart,
                                       const Report& report, std::optional<ExecutionMode> mode, std::string date,
                                       const Limits& limits, Diagnostics& diagnostics);

}  // namespace grafverif::python
