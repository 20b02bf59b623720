// SPDX-License-Identifier: MIT
// Constants of a closed loop, in words: `N = 4 (set), T = 3s`.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/named_constant.hpp"

namespace grafverif {

/// `4`, `true`, `3s`.
std::string value_text(const NamedConstant& constant);
/// All of them, those that are set from outside marked; empty: there is none.
std::string constants_text(const std::vector<NamedConstant>& constants);

}  // namespace grafverif
