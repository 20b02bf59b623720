// SPDX-License-Identifier: MIT
// The page of `grafverif report`, made from a report that Python has.
#pragma once

#include <optional>
#include <string>

#include "grafverif/grafverif.hpp"

namespace grafverif::python {

/// The page of a report on `loop`, or on `chart` alone if `loop` is not valid; empty after an error.
std::optional<std::string> report_page(const ParseResult& reading, Id<ClosedLoop> loop, Id<Chart> chart,
                                       const Report& report, std::optional<ExecutionMode> mode, std::string date,
                                       const Limits& limits, Diagnostics& diagnostics);

}  // namespace grafverif::python
