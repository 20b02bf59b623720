// SPDX-License-Identifier: MIT
// Returns the operands of a property in the notation of conditions.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

std::vector<std::string> operand_texts(const Network& network, const Property& property);

}  // namespace grafverif
