// SPDX-License-Identifier: MIT
// Binary operators of terms on integers.
#pragma once

#include <cstdint>
#include <optional>

#include "grafverif/ir/expr.hpp"

namespace grafverif {

/// Returns the value of a comparison or arithmetic operator on integers (Booleans are 0 and 1); empty if undefined.
std::optional<std::int64_t> combine(Op op, std::int64_t left, std::int64_t right);

}  // namespace grafverif
