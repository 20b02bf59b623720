// SPDX-License-Identifier: MIT
// Writes a trace as a value change dump (IEEE 1364-2005, 18) for viewers such as GTKWave. The modules are `inputs`,
// `outputs`, `internals`, `plant`, and `steps` with the step variables. The signal `loop` is 1 from the first event
// that repeats forever.
//
// The time unit is a microsecond. Steps within one instant are separated by one microsecond to show their order.
#pragma once

#include <iosfwd>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

void print_vcd(const ChartRun& run, std::ostream& out);

}  // namespace grafverif
