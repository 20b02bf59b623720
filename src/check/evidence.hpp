// SPDX-License-Identifier: MIT
// What another program shows for its verdict, held against the system that it was asked about.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ir/flat_system.hpp"

namespace grafverif {

/// A run as a program tells it. States hold a value per variable of a FlatSystem, its choices those with which a step
/// leaves the state.
struct ToldRun {
    std::vector<std::vector<std::int64_t>> states = {};  ///< not empty
    std::optional<std::size_t> loop = {};                ///< a last step leads back to this state
};

/// Why `told` does not show that `property` is violated (of `reachable`: that it holds); empty: it does. Of `always
/// possible` and of formulas passed through it is asked only whether it is a run of the system. `flat`:
/// flattened(system), which gains terms.
std::string doubt(const TransitionSystem& system, FlatSystem& flat, const Property& property, const ToldRun& told);

}  // namespace grafverif
