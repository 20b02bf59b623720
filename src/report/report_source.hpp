// SPDX-License-Identifier: MIT
// Source positions of the elements of a report.
#pragma once

#include <optional>
#include <string>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/report.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

/// The model of a report: the loop, or a chart without a loop (`loop` is then invalid).
struct ReportSource {
    const Sources& sources;
    const Model& model;
    Id<ClosedLoop> loop = {};
    Id<Chart> chart = {};
};

/// Returns the position of the loop or of the chart.
Span origin(const ReportSource& written);
/// Returns the position of the property. For a constraint of a component of the library, the result is the position of
/// the instance; for an implicit property, the result is the position of the loop.
Span origin(const ReportSource& written, const Verdict& verdict);
/// Returns the position of the element that causes row `index` of a run: the cleared transition, the moving instance or
/// the active step. For a delay, the result is the position of the previous row.
Span origin(const ReportSource& written, const ChartRun& run, std::size_t index);

/// File, line and column (in bytes) of a span in a file.
struct FilePlace {
    std::string file = {};
    Place at = {};
};
std::optional<FilePlace> file_place(const Sources& sources, Span where);

}  // namespace grafverif
