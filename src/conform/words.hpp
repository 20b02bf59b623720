// SPDX-License-Identifier: MIT
// Values of inputs in words, as messages and reports tell them.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "grafverif/ir/type.hpp"

namespace grafverif::conform {

/// `s, not h1, level = 3`.
std::string inputs_text(const std::vector<std::pair<std::string, Type>>& inputs, const std::vector<std::int64_t>& values);

}  // namespace grafverif::conform
