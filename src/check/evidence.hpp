// SPDX-License-Identifier: MIT
// Checks the run that an external program returns with its verdict: it must be a run of the system and show the
// verdict.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ir/flat_system.hpp"

namespace grafverif {

/// A run given by an external program. A state has one value per variable of a FlatSystem; the values of choices are
/// those of the step from this state.
struct ExternalTrace {
    std::vector<std::vector<std::int64_t>> states = {};  ///< never empty
    std::optional<std::size_t> loop = {};  ///< index of the state to which a further step leads from the last state
};

/// Returns the reason why `trace` does not show that `property` is violated (for `reachable`: that it holds); empty if
/// it shows this. For `always possible` and for formulas passed to the program unchanged, the function only checks that
/// `trace` is a run of the system. `flat` must be flattened(system); the function adds terms to it.
std::string doubt(const TransitionSystem& system, FlatSystem& flat, const Property& property,
                  const ExternalTrace& trace);

}  // namespace grafverif
