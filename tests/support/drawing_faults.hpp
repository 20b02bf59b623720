// SPDX-License-Identifier: MIT
// Checks the readability of a drawing, based only on the elements in the drawing. Faults are overlapping boxes or
// texts, lines through them, oblique lines, and upward links without an arrow.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/drawing.hpp"

namespace grafverif {

/// Returns one sentence for each fault, and nothing for a readable drawing.
std::vector<std::string> faults(const Drawing& drawing);

}  // namespace grafverif
