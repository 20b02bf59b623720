// SPDX-License-Identifier: MIT
// What makes a drawing unreadable, found by looking at its marks alone: boxes or texts on each other, lines through
// them, oblique lines, links upward without an arrow.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/drawing.hpp"

namespace grafverif {

/// One sentence each; empty for a good drawing.
std::vector<std::string> faults(const Drawing& drawing);

}  // namespace grafverif
