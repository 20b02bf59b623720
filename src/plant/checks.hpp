// SPDX-License-Identifier: MIT
// What can be wrong with a plant although each of its components is well-formed.
#pragma once

#include "grafverif/ir/network.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Error `urgent-invariant`: an urgent edge whose target invariant can fail when it fires. UPPAAL blocks delay on the
/// guard alone, so such an edge would stop time where our semantics lets it pass.
void check_urgent_invariants(const Network& network, Diagnostics& diagnostics);

/// Warning `range-skipped` (CEP13 4.1): an integer moved in steps longer than a range that another process detects.
void warn_skipped_ranges(const Network& network, Diagnostics& diagnostics);

}  // namespace grafverif
