// SPDX-License-Identifier: MIT
// Compares charts and PLC programs. The public API only compares charts.
#pragma once

#include <optional>

#include "grafverif/grafverif.hpp"
#include "pipeline/variants/match_sides.hpp"

namespace grafverif {

/// An operand of a comparison: a PLC program if `program` is valid, otherwise a chart.
struct CompareOperand {
    const Model* model = nullptr;
    Id<Chart> chart = {};
    Id<Source> program = {};
};

/// Decides if both operands have equal outputs for all input sequences. If a program has a task with an interval, this
/// interval is the time between two scans of both operands. Otherwise, the time between two scans is any multiple of
/// the resolution (1 ms by default). The result is empty after an error.
std::optional<Comparison> compare(const CompareOperand& a, const CompareOperand& b, const CompareOptions& options,
                                  const ProgramCompareOptions& of_programs, Sources& sources, Diagnostics& diagnostics);

}  // namespace grafverif
