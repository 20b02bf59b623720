// SPDX-License-Identifier: MIT
// Static variable order of a system for decision diagrams: variables that occur in the same terms are placed near each
// other.
#pragma once

#include <vector>

#include "ir/flat_system.hpp"

namespace grafverif::symbolic {

/// Returns all variables in their order, beginning with the topmost variable.
std::vector<Id<FlatSystem::Variable>> variable_order(const FlatSystem& flat);

}  // namespace grafverif::symbolic
