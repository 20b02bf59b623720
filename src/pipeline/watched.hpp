// SPDX-License-Identifier: MIT
// Converts the operands of properties to text.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Returns the operands of a property in the notation of conditions.
std::vector<std::string> operand_texts(const Network& network, const Property& property);

}  // namespace grafverif
