// SPDX-License-Identifier: MIT
#include "run/project.hpp"

namespace grafverif {

void ChartView::add_step(ChartRun::Controller& controller, const StepName& name, std::uint32_t key) {
    controller.steps.push_back(run_->steps.add({name, alone_ ? "" : controller.name, ""}));
    step_keys_.push_back(key);
}

Id<ChartRun::Signal> ChartView::add_signal(std::uint32_t key, ChartRun::Signal signal) {
    if (signals_[key].valid()) return signals_[key];
    signal_keys_.push_back(key);
    return signals_[key] = run_->signals.add(std::move(signal));
}

ChartRun::State ChartView::state(std::int64_t time_ms, const std::vector<std::int64_t>& values) const {
    ChartRun::State state{.time_ms = time_ms};
    state.values.reserve(signal_keys_.size());
    for (const std::uint32_t key : signal_keys_) state.values.push_back(values[key]);
    for (std::uint32_t step = 0; step < step_keys_.size(); ++step)
        if (values[step_keys_[step]] != 0) state.situation.push_back({step});
    return state;
}

}  // namespace grafverif
