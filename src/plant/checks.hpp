// SPDX-License-Identifier: MIT
// Checks of a plant whose components are well-formed individually.
#pragma once

#include "grafverif/ir/network.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Error `urgent-invariant`: an urgent edge whose target invariant can be false when it is taken. UPPAAL blocks delay
/// according to the guard alone, so such an edge would stop time although the semantics of grafverif lets it pass.
void check_urgent_invariants(const Network& network, Diagnostics& diagnostics);

/// Warning `range-skipped` (CEP13 4.1): an integer changes in steps larger than a range that another process detects.
void warn_skipped_ranges(const Network& network, Diagnostics& diagnostics);

}  // namespace grafverif
