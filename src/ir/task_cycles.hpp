// SPDX-License-Identifier: MIT
// Controllers whose scans are started by a clock (TaskCycle).
#pragma once

#include <algorithm>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/network.hpp"

namespace grafverif {

/// True if a controller of the loop has a task cycle; otherwise all cycle times are zero.
inline bool has_task_cycle(const ClosedLoop& loop) {
    return std::ranges::any_of(loop.controllers, [](const auto& controller) { return controller.cycle.has_value(); });
}
inline bool has_task_cycle(const Network& network) {
    return std::ranges::any_of(network.controllers, [](const auto& each) { return each.words.cycle.has_value(); });
}

}  // namespace grafverif
