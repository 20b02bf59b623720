// SPDX-License-Identifier: MIT
// A trace as a timing diagram to look at: one column per step, so that what happens within one instant can be seen;
// time stands at the top where it goes on, what happened is written above each column. One row per input, output,
// internal variable, variable of the plant, and step of the charts; those that are 0 throughout are named at the foot.
// What repeats for ever has a shaded background.
#pragma once

#include <iosfwd>
#include <string_view>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

void print_svg(const ChartRun& run, std::string_view title, std::ostream& out);

}  // namespace grafverif
