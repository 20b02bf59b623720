// SPDX-License-Identifier: MIT
// Where what a report is about was written.
#pragma once

#include <optional>
#include <string>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/report.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

/// The model of a report: the loop, or a chart alone (then `loop` is not valid).
struct Written {
    const Sources& sources;
    const Model& model;
    Id<ClosedLoop> loop = {};
    Id<Chart> chart = {};
};

/// Of the loop, or the chart.
Span origin(const Written& written);
/// Of the property; of what the model does not ask for, or a component of the library says, that of the loop.
Span origin(const Written& written, const Verdict& verdict);
/// Where the loop or its charts say what happens in row `index` of a run: the transition that is cleared, the instance that
/// moves, the step that is active; of a delay, what was before it.
Span origin(const Written& written, const ChartRun& run, std::size_t index);

/// File, line and column (in bytes), where the span is of a file.
struct FilePlace {
    std::string file = {};
    Place at = {};
};
std::optional<FilePlace> file_place(const Sources& sources, Span where);

}  // namespace grafverif
