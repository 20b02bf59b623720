// SPDX-License-Identifier: MIT
// Checks of a plant whose components are well-formed individually.
#pragma once

#include "grafverif/ir/network.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Reports the error `urgent-invariant`: an urgent edge whose target invariant can be false when the edge is taken.
/// UPPAAL blocks delay according to the guard alone. Therefore such an edge would stop time although the semantics of
/// grafverif lets it pass.
void check_urgent_invariants(const Network& network, Diagnostics& diagnostics);

/// Reports the warning `range-skipped` (CEP13 4.1): an integer changes in steps that are larger than a range that
/// another process detects.
void warn_skipped_ranges(const Network& network, Diagnostics& diagnostics);

}  // namespace grafverif
