// SPDX-License-Identifier: MIT
// Vacuity detection by probes: evaluates the verdicts on probes (ir/probes.hpp) for their properties.
#pragma once

#include <vector>

#include "grafverif/ir/verdict.hpp"
#include "grafverif/support/table.hpp"
#include "ir/probes.hpp"

namespace grafverif {

/// Marks properties that hold vacuously, by the first of their probes that is violated; if none is, notes an undecided
/// probe. The verdicts on probes, which are in `properties` too, are not results and stay in the list.
void apply_probes(const Table<Property>& properties, std::vector<Verdict>& verdicts);

/// Adds probes for properties that external programs decide without vacuity: declared `leads to`, and properties of all
/// states `at stable` (only if `settled`: the model represents quiescence).
void add_external_probes(Exprs& exprs, Table<Property>& properties, bool settled);

}  // namespace grafverif
