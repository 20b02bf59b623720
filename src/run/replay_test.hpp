// SPDX-License-Identifier: MIT
// A test sequence on the interpreter of the rules of IEC 60848: what a PLC that does as the chart says would answer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/test_sequence.hpp"

namespace grafverif {

/// The first scan in which the chart answers otherwise than `test` expects, in words; empty: it passes. Requires that
/// the inputs and outputs of the test are those of the chart, in its order.
std::optional<std::string> disagreement(const Chart& chart, const TestSequence& test);

/// What the chart does in each sequence of a test, whatever that expects: a row per scan. Where the chart has no meaning the
/// last row says why.
std::vector<ChartRun> runs_of(const Chart& chart, const TestSequence& test);

}  // namespace grafverif
