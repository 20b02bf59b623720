// SPDX-License-Identifier: MIT
// Converts a run to a JSON value, for every report with a run.
#pragma once

#include <nlohmann/json.hpp>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

nlohmann::ordered_json trace_json(const ChartRun& run);
/// Returns the member `run`: the complete run (docs/reference/trace-format.md).
nlohmann::ordered_json run_json(const ChartRun& run);

}  // namespace grafverif
