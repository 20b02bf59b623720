// SPDX-License-Identifier: MIT
// ExecutionMode: how a PLC executes a chart (JESA13 section 3.2, Algorithms 1 and 2).
#pragma once

#include <string_view>

namespace grafverif {

/// Outputs are written once the situation is stable, or in every cycle.
enum class ExecutionMode { StabilitySearch, EveryCycle };

/// `stability-search`, `every-cycle`.
constexpr std::string_view word(ExecutionMode mode) {
    return mode == ExecutionMode::StabilitySearch ? "stability-search" : "every-cycle";
}

}  // namespace grafverif
