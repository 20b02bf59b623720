// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <unordered_set>
#include <utility>
#include <vector>

#include "bdd/space.hpp"

namespace grafverif::bdd {

/// The nodes of a function, constants apart, the lowest variables first: children come before parents.
std::vector<int> nodes_of(int root);

}  // namespace grafverif::bdd
