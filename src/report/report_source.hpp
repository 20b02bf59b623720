// SPDX-License-Identifier: MIT
// Source locations of the elements of a report.
#pragma once

#include <optional>
#include <string>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/report.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

/// The model of a report: the loop, or a chart alone (then `loop` is not valid).
struct ReportSource {
    const Sources& sources;
    const Model& model;
    Id<ClosedLoop> loop = {};
    Id<Chart> chart = {};
};

/// The location of the loop, or of the chart.
Span origin(const ReportSource& written);
/// The location of the property; of the loop if the property is implicit or from a component of the library.
Span origin(const ReportSource& written, const Verdict& verdict);
/// The location of the element that causes row `index` of a run: the cleared transition, the moving instance, the
/// active step; for a delay that of the row before.
Span origin(const ReportSource& written, const ChartRun& run, std::size_t index);

/// File, line and column (in bytes), if the span is in a file.
struct FilePlace {
    std::string file = {};
    Place at = {};
};
std::optional<FilePlace> file_place(const Sources& sources, Span where);

}  // namespace grafverif
