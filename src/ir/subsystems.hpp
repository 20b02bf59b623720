// SPDX-License-Identifier: MIT
// Parts (independent subsystems) of a TransitionSystem. In each step, at most one part moves. The functions of this
// file assign symbols to parts and project a system to some parts.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/transition_system.hpp"
#include "ir/flat_system.hpp"

namespace grafverif {

/// A list of parts of a system, in order.
using PartList = std::vector<std::uint32_t>;

constexpr std::uint32_t no_part = 0xFFFFFFFF;

/// Returns the part of each symbol of main, or no_part if the symbol belongs to no part or to several parts.
std::vector<std::uint32_t> parts_of_symbols(const TransitionSystem& system);

/// Returns the system without properties and without the parts that are not in `chosen`. Omitted parts never move and
/// do not block any step. Symbols of main keep their ids. Data about charts and plant is removed, except for `settled`.
TransitionSystem with_parts(const TransitionSystem& system, const PartList& chosen);

/// Maps each variable of `part`, a flattened projection, to the corresponding variable of `whole`, the flattened
/// complete system.
std::vector<Id<FlatSystem::Variable>> variables_in_complete(const FlatSystem& part, const FlatSystem& whole);

}  // namespace grafverif
