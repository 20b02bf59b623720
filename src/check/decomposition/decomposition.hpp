// SPDX-License-Identifier: MIT
// Compositional checking with the timed engine. A property is decided on the independent subsystems ("sub-loops") that
// it reads. Other subsystems, which share only time with these, are omitted if this preserves the verdict
// (docs/explanation/decomposition.md, "Sub-loops"). The side conditions on an omitted subsystem are checked by a
// separate exploration of this subsystem. If a condition fails or is unknown, the complete network is explored.
//
// `no deadlock` is checked per subsystem: from every state of each subsystem, one of its edges is enabled, immediately
// or after a delay. This condition is stronger than `no deadlock` of the complete network, in which an active subsystem
// hides a blocked subsystem.
//
// Each verdict names the omitted subsystems and states the reason. All runs are runs of the complete network.
#pragma once

#include "check/timed/timed.hpp"

namespace grafverif {

/// Checks the properties in the same way as check_timed. The limits apply to each search. Requires
/// verify(network).empty().
TimedResult check_timed_by_parts(const Network& network, const TimedOptions& options = {});

}  // namespace grafverif
