// SPDX-License-Identifier: MIT
// Validates the run that an external program gives for its verdict, with the system that was checked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ir/flat_system.hpp"

namespace grafverif {

/// A run given by an external program. A state has one value per variable of a FlatSystem. Its choices are those of the
/// step that leaves the state.
struct ExternalTrace {
    std::vector<std::vector<std::int64_t>> states = {};  ///< never empty
    std::optional<std::size_t> loop = {};  ///< a further step leads from the last state back to this state
};

/// Returns the reason why `told` does not show that `property` is violated (for `reachable`: that it holds); empty if
/// it does. For `always possible` and for formulas passed to the program unchanged, the function only checks that
/// `told` is a run of the system. `flat` is flattened(system); terms are added to it.
std::string doubt(const TransitionSystem& system, FlatSystem& flat, const Property& property,
                  const ExternalTrace& told);

}  // namespace grafverif
