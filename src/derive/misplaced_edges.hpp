// SPDX-License-Identifier: MIT
// Edges where the standard allows none, or asks for one: refused, each at its place.
#pragma once

#include "grafverif/ir/chart.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Whether an edge stands under a time or in an assignation condition, or an event has none; adds an error for each.
bool misplaced_edges(const Chart& chart, Diagnostics& diagnostics);

}  // namespace grafverif
