// SPDX-License-Identifier: MIT
// Text: what the verdicts of an untimed model imply for the timed closed loop. One paragraph for the header of the
// model and for reports; it depends on approach, schedule and type of property.
#pragma once

#include <span>
#include <string>

#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/network.hpp"
#include "schedule/controller_instances.hpp"

namespace grafverif::schedule {

/// The controllers alone; `constrained`: with constraints on their inputs.
std::string controllers_scope(std::span<const ControllerPart> controllers, bool constrained);
/// Controllers and plant automata, synchronous or sequenced.
std::string together_scope(Schedule schedule, std::span<const ControllerPart> controllers, bool fairness);
/// The network, one process at a time.
std::string network_scope(const Network& network, const ScheduleOptions& options);

}  // namespace grafverif::schedule
