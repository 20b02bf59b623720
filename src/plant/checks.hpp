// SPDX-License-Identifier: MIT
// Checks a complete plant, after each component has been checked separately.
#pragma once

#include "grafverif/ir/network.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Reports the error `urgent-invariant`: an urgent edge whose target invariant can be false when the edge is taken. In
/// UPPAAL, an urgent edge prevents delays whenever its guard holds, even if the target invariant is false. Therefore
/// time would stop in UPPAAL, although time can pass in the semantics of grafverif.
void check_urgent_invariants(const Network& network, Diagnostics& diagnostics);

/// Reports the warning `range-skipped` (CEP13 4.1): an integer changes by more than the width of a range in which
/// another process detects it, so that the process can miss the value.
void warn_skipped_ranges(const Network& network, Diagnostics& diagnostics);

}  // namespace grafverif
