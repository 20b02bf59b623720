// SPDX-License-Identifier: MIT
// Validates the run that an external program gives for its verdict, on the system that was checked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ir/flat_system.hpp"

namespace grafverif {

/// A run given by an external program. States hold a value per variable of a FlatSystem; its choices are those of the
/// step that leaves the state.
struct ExternalTrace {
    std::vector<std::vector<std::int64_t>> states = {};  ///< not empty
    std::optional<std::size_t> loop = {};                ///< a last step leads back to this state
};

/// The reason why `told` does not show that `property` is violated (of `reachable`: that it holds); empty if it does.
/// For `always possible` and for passed-through formulas, only checks that it is a run of the system. `flat`:
/// flattened(system), which gains terms.
std::string doubt(const TransitionSystem& system, FlatSystem& flat, const Property& property,
                  const ExternalTrace& told);

}  // namespace grafverif
