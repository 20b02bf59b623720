// SPDX-License-Identifier: MIT
// drawing_of: creates the drawing of a chart. Partial charts are placed next to each other; a partial chart with a name
// has a frame with this name. The layout of each partial chart is computed separately, in five stages: Flow, Order,
// Blocks, Columns (x positions) and Routes (y positions and lines). Equal charts have equal drawings. The cost is
// linear in the size of the chart.
#pragma once

#include "draw/chart_text.hpp"
#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/drawing.hpp"

namespace grafverif::draw {

Drawing drawing_of(const Chart& chart, const DrawOptions& options, const ChartText& text = {});

}  // namespace grafverif::draw
