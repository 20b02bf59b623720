// SPDX-License-Identifier: MIT
#include "simulate/trial.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace grafverif {

std::optional<Trial> trial_of(const ChartRun& run, std::string_view step, bool active) {
    for (const Id<ChartRun::Controller> id : run.controllers.ids()) {
        const auto& steps = run.controllers[id].steps;
        const auto found = std::ranges::find_if(steps, [&](auto each) {
            return run.steps[each].full_name() == step || run.steps[each].short_name == step;
        });
        if (found != steps.end()) return Trial{id, static_cast<std::size_t>(found - steps.begin()), active};
    }
    return {};
}

std::size_t tell_trial(ChartRun& run, Teller& teller, const Trial& trial) {
    teller.flush();
    const ChartRun::Step& step = run.steps[run.controllers[trial.controller].steps[trial.step]];
    run.rows.push_back({.kind = ChartRun::Kind::Environment,
                        .what = fmt::format("TRIAL: step {} {} by hand; not a run of the model from here on",
                                            step.short_name, trial.active ? "activated" : "deactivated"),
                        .moment = run.moments.size() - 1});
    return run.rows.size() - 1;
}

}  // namespace grafverif
