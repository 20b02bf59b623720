// SPDX-License-Identifier: MIT
// Converts closed loops to untimed models. The functions are fixtures for tests of schedules and of
// untimed engines.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/transition_system.hpp"

namespace grafverif {

/// Converts the first loop of `model`, in grain `grain` if the schedule is interleaved. Throws std::invalid_argument
/// with the first error if the loop cannot be converted. Fails the test if verify finds an error.
TransitionSystem untimed_loop(const Model& model, const ScheduleOptions& options, Grain grain = Grain::Phased);

/// Converts the first loop of `model` in every plant approach and under every schedule, in both grains if the schedule
/// is interleaved, with discrete and with abstract time. Rejected combinations are omitted. Fails the test if verify
/// finds an error.
std::vector<TransitionSystem> untimed_models(const Model& model, bool fairness = false);

/// The functions untimed_text and untimed_sample convert a loop in the same way as untimed_loop:
/// the first loop of `text` or of samples/PATH. The texts may use components of templates/.
TransitionSystem untimed_text(const std::string& text, const ScheduleOptions& options, Grain grain = Grain::Phased);
TransitionSystem untimed_sample(const std::string& path, const ScheduleOptions& options, Grain grain = Grain::Phased);

}  // namespace grafverif
