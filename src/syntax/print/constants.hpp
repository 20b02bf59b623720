// SPDX-License-Identifier: MIT
// Constants of a closed loop as text, such as `N = 4 (set), T = 3s`.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/named_constant.hpp"

namespace grafverif {

/// Returns text such as `4`, `true`, `3s`.
std::string value_text(const NamedConstant& constant);
/// Lists all constants and marks those that the user has set; empty if there are none.
std::string constants_text(const std::vector<NamedConstant>& constants);

}  // namespace grafverif
