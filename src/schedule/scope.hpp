// SPDX-License-Identifier: MIT
// Texts that state what the verdicts on an untimed model imply for the timed closed loop. Each text is one paragraph
// for the header of the model and for reports. The text depends on the approach and the schedule, and treats each type
// of property separately.
#pragma once

#include <span>
#include <string>

#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/network.hpp"
#include "schedule/controller_instances.hpp"

namespace grafverif::schedule {

/// Returns the text for controllers without a plant. `constrained` is true if the model assumes constraints on the
/// inputs.
std::string controllers_scope(std::span<const ControllerPart> controllers, bool constrained);
/// Returns the text for controllers and plant automata with the schedule synchronous or sequenced.
std::string together_scope(Schedule schedule, std::span<const ControllerPart> controllers, bool fairness);
/// Returns the text for controllers and plant automata with the schedule interleaved.
std::string network_scope(const Network& network, const ScheduleOptions& options);

}  // namespace grafverif::schedule
