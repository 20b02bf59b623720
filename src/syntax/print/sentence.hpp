// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "grafverif/ir/closed_loop.hpp"

namespace grafverif {

/// What is to prove of a constraint beside a plant, in words: `!(IN && OUT)` holds of it.
std::string sentence(const ClosedLoop& loop, const ClosedLoop::Constraint& constraint);

}  // namespace grafverif
