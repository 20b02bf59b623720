// SPDX-License-Identifier: MIT
// drawing_of: creates the drawing of a chart. Partial charts are placed next to each other; named ones have a frame
// with their name. Each is laid out separately in the stages Flow, Order, Blocks, Columns, Routes. Equal charts have
// equal drawings. The cost is linear.
#pragma once

#include "draw/chart_text.hpp"
#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/drawing.hpp"

namespace grafverif::draw {

Drawing drawing_of(const Chart& chart, const DrawOptions& options, const ChartText& text = {});

}  // namespace grafverif::draw
