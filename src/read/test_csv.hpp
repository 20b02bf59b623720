// SPDX-License-Identifier: MIT
// read/test_csv: a table of inputs and expected outputs (CSV, RFC 4180) -> TestSequence of one chart.
//
// The first row names the columns: every input and every output of the chart, and as far as wanted `sequence` (default:
// one), `step`, `wait`, `cycles` (default: 1) and `situation`, as syntax/test_csv writes them. A name that is a variable of
// the chart is that variable, unless the row begins as syntax/test_csv begins it. A new value of `sequence` begins a
// sequence at power-on; `step` 0 is its activation.
#pragma once

#include <optional>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/test_sequence.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

/// Empty after at least one error. Guarantees verify(test).empty(). Nothing is known of what it covers.
std::optional<TestSequence> read_test_csv(Id<Source> file, const Sources& sources, const Chart& chart,
                                          ExecutionMode mode, Diagnostics& diagnostics);

}  // namespace grafverif
