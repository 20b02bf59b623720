// SPDX-License-Identifier: MIT
// What-if run: the user forces a step to be activated or deactivated, to explore the consequences. From the row of this
// change on, the recording is not a run of the model and is marked accordingly.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "grafverif/ir/chart_run.hpp"
#include "report/trace_rows.hpp"

namespace grafverif {

struct WhatIfRun {
    Id<ChartRun::Controller> controller = {};
    std::size_t step = 0;  ///< index of the step in Controller::steps
    bool active = false;
};

/// Resolves a name such as `3`, `X3`, `G1.3` or `press.G1.3` (see steps_called). The result is empty after an error,
/// with the reason in `problem`.
std::optional<WhatIfRun> what_if_of(const ChartRun& run, std::string_view step, bool active, std::string& problem);

/// Adds a row for the forced change of the step. The event of the change must be the last event of the run, and must
/// not have a row yet. Returns the index of the row.
std::size_t report_what_if(ChartRun& run, TraceRowBuilder& teller, const WhatIfRun& trial);

}  // namespace grafverif
