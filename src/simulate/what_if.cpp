// SPDX-License-Identifier: MIT
#include "simulate/what_if.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "simulate/called.hpp"
#include "support/overloaded.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif {

std::optional<WhatIfRun> what_if_of(const ChartRun& run, std::string_view step, bool active, std::string& problem) {
    const std::vector<Id<ChartRun::Step>> meant = steps_called(run, step);
    std::vector<std::string> names;
    for (const ChartRun::Step& each : run.steps) names.push_back(each.full_name());
    if (meant.empty()) return problem = unknown_name_text("step", step, names), std::nullopt;
    if (meant.size() > 1)
        return problem = ambiguous_text(step, {names[meant[0].index], names[meant[1].index]}), std::nullopt;
    for (const Id<ChartRun::Controller> id : run.controllers.ids()) {
        const auto& steps = run.controllers[id].steps;
        const auto found = std::ranges::find(steps, meant.front());
        if (found != steps.end()) return WhatIfRun{id, static_cast<std::size_t>(found - steps.begin()), active};
    }
    unreachable();
}

std::size_t report_what_if(ChartRun& run, TraceRowBuilder& teller, const WhatIfRun& trial) {
    teller.flush();
    const ChartRun::Step& step = run.steps[run.controllers[trial.controller].steps[trial.step]];
    run.rows.push_back({.kind = ChartRun::Kind::Environment,
                        .what = fmt::format("WHAT-IF: step {} was forced {}; the trace is no longer a run of the model",
                                            step.short_name, trial.active ? "active" : "inactive"),
                        .moment = run.moments.size() - 1});
    return run.rows.size() - 1;
}

}  // namespace grafverif
