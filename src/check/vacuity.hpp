// SPDX-License-Identifier: MIT
// Detects vacuous properties by the verdicts on their probes (ir/probes.hpp).
#pragma once

#include <vector>

#include "grafverif/ir/verdict.hpp"
#include "grafverif/support/table.hpp"
#include "ir/probes.hpp"

namespace grafverif {

/// Marks the properties that hold vacuously: a property is vacuous if one of its probes is violated, and the first
/// violated probe determines the note. If no probe is violated, but a probe is undecided, a note is added. `properties`
/// also contains the probes. Their verdicts are not results, but remain in `verdicts`.
void apply_probes(const Table<Property>& properties, std::vector<Verdict>& verdicts);

/// Adds probes for properties for which external programs do not detect vacuity: declared `leads to`, and, if `settled`
/// is true, properties of all states with `at stable`. `settled` is true if the model represents quiescence.
void add_external_probes(Exprs& exprs, Table<Property>& properties, bool settled);

}  // namespace grafverif
