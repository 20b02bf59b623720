// SPDX-License-Identifier: MIT
// Texts of diagnostics about recordings (logs) of a controller.
#pragma once

#include <string_view>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::messages {

/// `problem` describes the problem and the remedy.
Diagnostic bad_log(Span where, std::string_view problem);
/// `names` lists inputs or outputs of the chart without a column, in backticks.
Diagnostic unrecorded_inputs(Span where, std::string_view chart, std::string_view names);
Diagnostic unrecorded_outputs(std::string_view chart, std::string_view names);
/// None of the outputs of the chart has a column.
Diagnostic no_recorded_output(Span where, std::string_view chart);
Diagnostic ignored_columns(Span where, std::string_view names);

}  // namespace grafverif::messages
