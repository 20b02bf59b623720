// SPDX-License-Identifier: MIT
// Validates the trace that an external program returns with its verdict: the trace must be a run of the system, and
// this run must prove the verdict.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ir/flat_system.hpp"

namespace grafverif {

/// A run that an external program returned. A state has one value per variable of a FlatSystem; the values of choices
/// are the values in the step that leaves the state.
struct ExternalTrace {
    std::vector<std::vector<std::int64_t>> states = {};  ///< states in the order of the run; never empty

    /// Index of the state to which the step from the last state leads back; empty for a finite run.
    std::optional<std::size_t> loop = {};
};

/// Returns the reason why `trace` does not show that `property` is violated (for `reachable`: that `property` holds),
/// or an empty string if `trace` shows it. For `always possible` and for formulas passed to the program unchanged, the
/// function only checks that `trace` is a run of the system. `flat` must be flattened(system); the function adds terms
/// to it.
std::string doubt(const TransitionSystem& system, FlatSystem& flat, const Property& property,
                  const ExternalTrace& trace);

}  // namespace grafverif
