// SPDX-License-Identifier: MIT
// A trace as a timing diagram to look at: one column per event, so that what happens within one instant can be seen;
// events are numbered as `steps` of the JSON form are, time stands where it goes on, what happened is written above each
// column. Long traces are cut into strips, each with the names of its rows. One row per input, output,
// internal variable, variable of the plant, and step of the charts; those that are 0 throughout are named at the foot.
// What repeats for ever has a shaded background.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <limits>
#include <string_view>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

/// Events to be drawn; those that there are not are left out, but for the last one.
struct EventRange {
    std::size_t from = 0, to = std::numeric_limits<std::size_t>::max();
};

void print_svg(const ChartRun& run, std::string_view title, EventRange range, std::ostream& out);

}  // namespace grafverif
