// SPDX-License-Identifier: MIT
// Writes a trace as a timing diagram with one column per row of the printed trace, so that events within one instant
// are visible. The columns are numbered from 0. A column has a time label if time has advanced since the previous
// column. The event is printed above each column. Long traces are divided into strips, each with the names of its rows.
// There is one row per input, output, internal variable, variable of the plant, and step of the charts. Rows that would
// be constantly 0 are listed at the foot instead. Columns whose events repeat forever have a shaded background.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <limits>
#include <string_view>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

/// Range of the events to draw. Event numbers beyond the end of the run are ignored; if the complete range is beyond
/// the end, the last event is drawn.
struct EventRange {
    std::size_t from = 0, to = std::numeric_limits<std::size_t>::max();
};

void print_svg(const ChartRun& run, std::string_view title, EventRange range, std::ostream& out);

}  // namespace grafverif
