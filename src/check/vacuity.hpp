// SPDX-License-Identifier: MIT
// Vacuity by probes: reads the verdicts on probes (ir/probes.hpp) into those on their properties.
#pragma once

#include <vector>

#include "grafverif/ir/verdict.hpp"
#include "grafverif/support/table.hpp"
#include "ir/probes.hpp"

namespace grafverif {

/// Marks what holds vacuously by the first of its probes that is violated; notes an undecided probe if none is. The verdicts
/// on probes, which are on `properties` as well, are no result and stay where they are.
void apply_probes(const Table<Property>& properties, std::vector<Verdict>& verdicts);

/// Adds the probes of what external programs decide without telling vacuity: a declared `leads to`, and properties of all
/// states `at stable` (only if `settled`: the model tells which states are).
void add_external_probes(Exprs& exprs, Table<Property>& properties, bool settled);

}  // namespace grafverif
