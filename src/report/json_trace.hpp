// SPDX-License-Identifier: MIT
// A run as a JSON value, for every report that has one.
#pragma once

#include <nlohmann/json.hpp>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

nlohmann::ordered_json trace_json(const ChartRun& run);
/// The member `run`: the complete run (docs/reference/trace-format.md).
nlohmann::ordered_json run_json(const ChartRun& run);

}  // namespace grafverif
