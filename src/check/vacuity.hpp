// SPDX-License-Identifier: MIT
// Detects properties that hold vacuously. The detection uses the verdicts on additional properties, the vacuity probes
// (ir/probes.hpp).
#pragma once

#include <vector>

#include "grafverif/ir/verdict.hpp"
#include "grafverif/support/table.hpp"
#include "ir/probes.hpp"

namespace grafverif {

/// Marks the properties that hold vacuously. A property that holds is vacuous if one of its probes is violated; the
/// first violated probe determines the note of the verdict. If no probe is violated, but the verdict on a probe is
/// unknown, a note states that the vacuity is unknown. `properties` also contains the probes. The verdicts on the
/// probes remain in `verdicts`; callers must not report them as results.
void apply_probes(const Table<Property>& properties, std::vector<Verdict>& verdicts);

/// Adds probes for properties for which external programs do not detect vacuity: declared `leads to` properties and, if
/// `settled` is true, properties about all states with `at stable`. `settled` must be true only if the model represents
/// quiescence.
void add_external_probes(Exprs& exprs, Table<Property>& properties, bool settled);

}  // namespace grafverif
