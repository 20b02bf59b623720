// SPDX-License-Identifier: MIT
// Determines the time unit of a closed loop, which is the duration of one tick of all clocks of its network.
#pragma once

#include <cstdint>
#include <optional>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/state_profile.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Returns the time unit in milliseconds. If the loop declares a unit, every duration must be a multiple of this unit.
/// Otherwise the unit is the greatest common divisor of all durations, or 1 s if there are no durations. Warns if a
/// duration exceeds 10,000 units.
std::optional<std::int64_t> time_unit(const Model& model, const ClosedLoop& loop, Diagnostics& diagnostics);

/// Returns the duration whose removal, at all its occurrences, would make the time unit coarsest, or nullopt if no
/// removal of a single duration makes the unit coarser. If the loop declares a time unit that is finer than its
/// durations require, the result contains the declared unit and the duration 0. If the loop declares any other time
/// unit, the result is nullopt.
std::optional<StateProfile::Finest> finest_duration(const Model& model, const ClosedLoop& loop);

}  // namespace grafverif
