// SPDX-License-Identifier: MIT
// A table of pairs of inputs that are never true together, as engineers keep it beside a chart:
//
//   variable1,variable2,reason
//   V_IN,V_OUT,"one cylinder, two ends"
//
// CSV by RFC 4180, with commas or semicolons. The first row is the header; empty rows and rows that begin with `#` are
// left out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

struct ExclusionRow {
    Id<Chart::Variable> first = {}, second = {};  ///< Boolean inputs of the chart, not the same
    std::string reason = {};
    Span origin = {};

    bool operator==(const ExclusionRow&) const = default;
};

/// The rows of `file`, or nothing after adding at least one error to `diagnostics`.
std::optional<std::vector<ExclusionRow>> read_exclusions(Id<Source> file, const Sources& sources, const Chart& chart,
                                                         Diagnostics& diagnostics);

}  // namespace grafverif
