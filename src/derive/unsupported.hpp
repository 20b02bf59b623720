// SPDX-License-Identifier: MIT
// What derive does not take yet, though a Chart holds it: refused by name, each at its place (code `unsupported`).
#pragma once

#include "grafverif/ir/chart.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Whether `chart` has an element that derive cannot give a meaning to; adds an error for each.
bool unsupported(const Chart& chart, Diagnostics& diagnostics);

}  // namespace grafverif
