// SPDX-License-Identifier: MIT
// Converts constants of a closed loop to text, such as `N = 4 (set), T = 3s`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/named_constant.hpp"

namespace grafverif {

/// Returns the value as text such as `4`, `true` or `3s`.
std::string value_text(const NamedConstant& constant);
/// Parses a value such as `4`, `true` or `3s`. The result is empty if `text` is not a value of the type `kind`.
std::optional<std::int64_t> value_of(NamedConstant::Kind kind, const std::string& text);
/// Returns a list of all constants as text, in which `(set)` marks constants that the user has set; empty if there are
/// no constants.
std::string constants_text(const std::vector<NamedConstant>& constants);

}  // namespace grafverif
