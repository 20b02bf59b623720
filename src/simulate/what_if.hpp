// SPDX-License-Identifier: MIT
// What-if step: the user forces a step to be activated or deactivated to see the consequences. From the row of this
// change on, the recording is not a run of the model, and it is marked accordingly.
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
    std::size_t step = 0;  ///< index among the steps of the controller
    bool active = false;
};

/// Resolves `3`, `X3`, `G1.3`, `press.G1.3` (see steps_called); empty after an error, with the reason in `problem`.
std::optional<WhatIfRun> what_if_of(const ChartRun& run, std::string_view step, bool active, std::string& problem);

/// Adds the row of the change. Its event is the last of the run and has no row yet. Returns the index of the row.
std::size_t report_what_if(ChartRun& run, TraceRowBuilder& teller, const WhatIfRun& trial);

}  // namespace grafverif
