// SPDX-License-Identifier: MIT
// read/test_csv: reads a table of inputs and expected outputs (CSV, RFC 4180) to a TestSequence of one chart.
//
// The first row contains the column names: every input and every output of the chart, and optionally `sequence`
// (default: a single sequence), `step`, `wait`, `cycles` (default: 1) and `situation`, as printed by
// syntax/print/test_csv. If a variable of the chart has the name of an optional column, the column contains the values
// of this variable. Exception: if the first row begins with `sequence`, `step`, `wait` and `cycles`, as printed by
// syntax/print/test_csv, these columns do not contain values of variables. A new value of `sequence` begins a new
// sequence at power-on. The row with `step` 0 is the scan that activates the initial steps.
#pragma once

#include <optional>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/test_sequence.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

/// Reads a test. The result is empty after at least one error. Guarantees verify(test).empty(). The coverage of the
/// result is unknown.
std::optional<TestSequence> read_test_csv(Id<Source> file, const Sources& sources, const Chart& chart,
                                          ExecutionMode mode, Diagnostics& diagnostics);

}  // namespace grafverif
