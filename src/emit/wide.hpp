// SPDX-License-Identifier: MIT
// What programs that compute with 32 bits cannot be given.
#pragma once

#include <string_view>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/transition_system.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Whether integers of 32 bits hold all values in the model; an error (`too-wide`) for each place of it where they may not. Of
/// clocks: constants up to 2^30 - 2 time units, which difference bounds of 32 bits hold (UPPAAL DBM library: `dbm_INFINITY`).
bool fits(const Network& network, std::string_view target, Diagnostics& diagnostics);
bool fits(const TransitionSystem& system, std::string_view target, Diagnostics& diagnostics);

}  // namespace grafverif
