// SPDX-License-Identifier: MIT
// The time unit of a closed loop: what one tick of every clock of its network stands for.
#pragma once

#include <cstdint>
#include <optional>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/state_profile.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// In milliseconds: the unit that the loop names, of which every duration must be a multiple, or the greatest common
/// divisor of all durations; 1 s where there is none. Warns where a duration has more than 10,000 units.
std::optional<std::int64_t> time_unit(const Model& model, const ClosedLoop& loop, Diagnostics& diagnostics);

/// The duration (each place where it is written counts) without which the time unit would be coarsest, if it would be
/// coarser than it is; where the loop names a unit finer than its durations ask for, that, with duration 0.
std::optional<StateProfile::Finest> finest_duration(const Model& model, const ClosedLoop& loop);

}  // namespace grafverif
