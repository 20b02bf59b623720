// SPDX-License-Identifier: MIT
// Static variable order of a system for decision diagrams: variables that terms read together are placed near each
// other.
#pragma once

#include <vector>

#include "ir/flat_system.hpp"

namespace grafverif::symbolic {

/// Returns every variable once, the topmost first.
std::vector<Id<FlatSystem::Variable>> variable_order(const FlatSystem& flat);

}  // namespace grafverif::symbolic
