// SPDX-License-Identifier: MIT
// Closed loops as untimed models: what tests of schedules and of untimed engines start from.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/transition_system.hpp"

namespace grafverif {

/// The first loop of `model`, in grain `grain` where the schedule is interleaved. Throws std::invalid_argument with the
/// first error where there is no such model; fails the test where verify finds anything.
TransitionSystem untimed_loop(const Model& model, const ScheduleOptions& options, Grain grain = Grain::Phased);

/// The first loop of `model` in every approach and under every schedule, in both grains where the schedule is interleaved,
/// with clocks that count and without; what is refused is left out. Fails the test where verify finds anything.
std::vector<TransitionSystem> untimed_models(const Model& model, bool fairness = false);

/// Of `text`, and of samples/PATH; components of templates/ may be used.
TransitionSystem untimed_text(const std::string& text, const ScheduleOptions& options, Grain grain = Grain::Phased);
TransitionSystem untimed_sample(const std::string& path, const ScheduleOptions& options, Grain grain = Grain::Phased);

}  // namespace grafverif
