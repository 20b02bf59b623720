// SPDX-License-Identifier: MIT
// A trace as a value change dump (IEEE 1364-2005, 18), for GTKWave and its kind: modules `inputs`, `outputs`,
// `internals`, `plant`, and `steps` with the step variables; `loop` is 1 from where the trace repeats for ever.
//
// One unit is a microsecond. Steps within one instant stand a microsecond apart, so that their order can be seen.
#pragma once

#include <iosfwd>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

void print_vcd(const ChartRun& run, std::ostream& out);

}  // namespace grafverif
