// SPDX-License-Identifier: MIT
// Writes a drawing as SVG. Colours are `currentColor` and `none`, and red for `changed` elements. They are set by
// attributes, so that the style of a page overrides them (docs/how-to/draw.md). There are no style sheets, no scripts,
// and no ids except those of the elements.
#pragma once

#include <iosfwd>

#include "grafverif/ir/drawing.hpp"

namespace grafverif::draw {

void print_svg(const Drawing& drawing, std::ostream& out);

}  // namespace grafverif::draw
