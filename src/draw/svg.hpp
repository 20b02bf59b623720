// SPDX-License-Identifier: MIT
// Writes a drawing as SVG. The colours are `currentColor` and `none`, and red for elements with the class `changed`.
// The SVG defines the colours by attributes, so that the style of a page can override them (docs/how-to/draw.md). The
// SVG contains no style sheets and no scripts; its only ids are the ids of elements of the chart.
#pragma once

#include <iosfwd>

#include "grafverif/ir/drawing.hpp"

namespace grafverif::draw {

void print_svg(const Drawing& drawing, std::ostream& out);

}  // namespace grafverif::draw
