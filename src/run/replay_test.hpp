// SPDX-License-Identifier: MIT
// Executes a test sequence on the interpreter of IEC 60848. The result is the expected behaviour of a PLC that
// implements the chart.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/test_sequence.hpp"

namespace grafverif {

/// Describes the first scan in which the outputs of the chart differ from the outputs that `test` expects; empty if the
/// test passes. Requires that the test has the same inputs and outputs as the chart, in the same order.
std::optional<std::string> disagreement(const Chart& chart, const TestSequence& test);

/// Returns the run of the chart in each sequence of a test, independently of the expected outputs, with one row per
/// scan. After a fault of the chart, the last row states the cause.
std::vector<ChartRun> runs_of(const Chart& chart, const TestSequence& test);

}  // namespace grafverif
