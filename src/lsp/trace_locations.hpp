// SPDX-License-Identifier: MIT
// Determines the source positions of a trace: the positions of cleared transitions and moving instances, in the order
// of the trace, each with its event and time.
#pragma once

#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"
#include "lsp/diagnostics.hpp"

namespace grafverif::lsp {

class TraceLocations {
public:
    TraceLocations(const Model& model, Id<ClosedLoop> loop, const Places& places)
        : model_(model), loop_(loop), places_(places) {}
    TraceLocations(const Model& model, Id<Chart> chart, const Places& places)
        : model_(model), chart_(chart), places_(places) {}

    /// Returns the positions of a run. The number of positions is limited for readability: for a long run, only the
    /// first and the last rows are included.
    std::vector<Related> of(const ChartRun& run) const;

private:
    Span origin_of(const ChartRun& run, const ChartRun::Row& row) const;
    const Chart* chart_named(const std::string& name) const;

    const Model& model_;
    Id<ClosedLoop> loop_ = {};
    Id<Chart> chart_ = {};
    const Places& places_;
};

}  // namespace grafverif::lsp
