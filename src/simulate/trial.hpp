// SPDX-License-Identifier: MIT
// A trial: somebody makes a step active, or not, by hand and looks what would follow. From its row on what is told is no run
// of the model, and says so.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "grafverif/ir/chart_run.hpp"
#include "report/tell.hpp"

namespace grafverif {

struct Trial {
    Id<ChartRun::Controller> controller = {};
    std::size_t step = 0;  ///< of the controller's
    bool active = false;
};

/// `3`, `X3`, `G1.3`, `press.G1.3` (see steps_called); empty: `problem` says why no step is meant.
std::optional<Trial> trial_of(const ChartRun& run, std::string_view step, bool active, std::string& problem);

/// Adds the row of a trial, whose moment is the last of the run and has not been told yet. The place of the row.
std::size_t tell_trial(ChartRun& run, Teller& teller, const Trial& trial);

}  // namespace grafverif
