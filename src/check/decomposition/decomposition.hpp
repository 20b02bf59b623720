// SPDX-License-Identifier: MIT
// Compositional checking with the timed engine. A property is decided on the independent subsystems ("sub-loops") that
// it reads. All other subsystems, which share only time with these subsystems, are omitted if the omission preserves
// the verdict (docs/explanation/decomposition.md, "Sub-loops"). The conditions under which the omission of a subsystem
// preserves the verdict are checked by a separate exploration of this subsystem. If a condition fails or is unknown,
// the complete network is explored.
//
// `no deadlock` is checked per subsystem: from every state of each subsystem, an edge of this subsystem is enabled,
// immediately or after a delay. The check per subsystem is stronger than `no deadlock` of the
// complete network, in which an active subsystem hides a blocked subsystem.
//
// Each verdict names the omitted subsystems and states why they do not affect the verdict. All runs are runs of the
// complete network.
#pragma once

#include "check/timed/timed.hpp"

namespace grafverif {

/// Checks the properties in the same way as check_timed. The limits on states and memory apply to each search
/// separately. Requires verify(network).empty().
TimedResult check_timed_by_parts(const Network& network, const TimedOptions& options = {});

}  // namespace grafverif
