// SPDX-License-Identifier: MIT
// The clocks of a network (ir/network_clocks) as the timed engine takes them, and where integer time is not exact.
#pragma once

#include <optional>
#include <string>

#include "grafverif/ir/network_clocks.hpp"

namespace grafverif::timed {

using Interval = ClockInterval;

/// The first place that integer time does not decide exactly: a strict constraint, or an urgent edge that time may
/// switch off. Empty where there is none.
std::optional<std::string> inexact_place(const Network& network);

}  // namespace grafverif::timed
