// SPDX-License-Identifier: MIT
// drawing_of: a chart as a drawing. Partial charts are placed next to each other, named ones in a frame with their
// name. Each is laid out separately: Flow, Order, Blocks, Columns, Routes. Equal charts give equal drawings, in linear
// time.
#pragma once

#include "draw/chart_text.hpp"
#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/drawing.hpp"

namespace grafverif::draw {

Drawing drawing_of(const Chart& chart, const DrawOptions& options, const ChartText& text = {});

}  // namespace grafverif::draw
