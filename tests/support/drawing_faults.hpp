// SPDX-License-Identifier: MIT
// Readability check of a drawing, based on its marks alone: overlapping boxes or texts, lines through them, oblique
// lines, upward links without an arrow.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/drawing.hpp"

namespace grafverif {

/// One sentence per fault; empty for a readable drawing.
std::vector<std::string> faults(const Drawing& drawing);

}  // namespace grafverif
