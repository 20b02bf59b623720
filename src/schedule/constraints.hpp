// SPDX-License-Identifier: MIT
// Constraints as invariants over free inputs (DESDES06 5.1).
#pragma once

#include "schedule/properties.hpp"

namespace grafverif::schedule {

/// Every constraint that reads inputs of controllers only holds in every state; others say nothing of this model.
void assume_constraints(TransitionSystem& system, const ClosedLoop& loop, const LoopMeaning& meaning);

}  // namespace grafverif::schedule
