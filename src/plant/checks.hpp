// SPDX-License-Identifier: MIT
// Checks of a complete plant, after each component has been checked separately.
#pragma once

#include "grafverif/ir/network.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Reports the error `urgent-invariant`: an urgent edge whose target invariant can be false when the edge is taken. In
/// UPPAAL, an urgent edge prevents delays whenever its guard holds. Therefore such an edge would stop time in UPPAAL
/// although time can pass in the semantics of grafverif.
void check_urgent_invariants(const Network& network, Diagnostics& diagnostics);

/// Reports the warning `range-skipped` (CEP13 4.1): a change of an integer is larger than a range that another process
/// detects.
void warn_skipped_ranges(const Network& network, Diagnostics& diagnostics);

}  // namespace grafverif
