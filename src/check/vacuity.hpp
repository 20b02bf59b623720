// SPDX-License-Identifier: MIT
// Vacuity detection by probes: evaluates the verdicts on probes (ir/probes.hpp) for their properties.
#pragma once

#include <vector>

#include "grafverif/ir/verdict.hpp"
#include "grafverif/support/table.hpp"
#include "ir/probes.hpp"

namespace grafverif {

/// Marks properties that hold vacuously, according to the first of their probes that is violated. If no probe is
/// violated but one is undecided, a note is added. The verdicts on probes, which are also in `properties`, are not
/// results and stay in the list.
void apply_probes(const Table<Property>& properties, std::vector<Verdict>& verdicts);

/// Adds probes for properties that external programs decide without regard to vacuity: declared `leads to`, and, if
/// `settled`, properties of all states with `at stable`. `settled` is true if the model represents quiescence.
void add_external_probes(Exprs& exprs, Table<Property>& properties, bool settled);

}  // namespace grafverif
