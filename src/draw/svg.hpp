// SPDX-License-Identifier: MIT
// A drawing as SVG. Colours are `currentColor` and `none`, and of what is `changed` a red for it, given by attributes, so that the style of a page wins over
// them (docs/drawing.md); it has no style sheet, no script and no ids but those of its elements.
#pragma once

#include <iosfwd>

#include "grafverif/ir/drawing.hpp"

namespace grafverif::draw {

void print_svg(const Drawing& drawing, std::ostream& out);

}  // namespace grafverif::draw
