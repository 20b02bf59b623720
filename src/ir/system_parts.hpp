// SPDX-License-Identifier: MIT
// Parts of a TransitionSystem, one of which moves in a step: what is theirs, and some of them as a system of their own.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/transition_system.hpp"
#include "ir/flat_system.hpp"

namespace grafverif {

/// Some parts of a system, in order.
using PartList = std::vector<std::uint32_t>;

constexpr std::uint32_t no_part = 0xFFFFFFFF;

/// Per symbol of main, the part that it is of; no_part: it is of none, or of several.
std::vector<std::uint32_t> parts_of_symbols(const TransitionSystem& system);

/// The system without all other parts and without properties: who is left out never moves and holds nobody up. Symbols
/// of main keep their ids, but for `settled` nothing is said of charts and plant.
TransitionSystem with_parts(const TransitionSystem& system, const PartList& chosen);

/// Per variable of `part`, made of some parts of the system that `whole` is made of, the same variable there.
std::vector<Id<FlatSystem::Variable>> variables_in_whole(const FlatSystem& part, const FlatSystem& whole);

}  // namespace grafverif
