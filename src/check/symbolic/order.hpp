// SPDX-License-Identifier: MIT
// Computes a static variable order for decision diagrams: variables that occur in the same terms are close together in
// the order.
#pragma once

#include <vector>

#include "ir/flat_system.hpp"

namespace grafverif::symbolic {

/// Returns all variables of the system, ordered from the topmost to the lowest level of the decision diagrams.
std::vector<Id<FlatSystem::Variable>> variable_order(const FlatSystem& flat);

}  // namespace grafverif::symbolic
