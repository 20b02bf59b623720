// SPDX-License-Identifier: MIT
// Reads exclusion tables: pairs of inputs that are never true simultaneously.
//
//   variable1,variable2,reason
//   V_IN,V_OUT,"one cylinder, two ends"
//
// The format is CSV (RFC 4180) with commas or semicolons. The first row is the header; the reader ignores empty rows
// and rows that begin with `#`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

struct ExclusionRow {
    Id<Chart::Variable> first = {}, second = {};  ///< two different Boolean inputs of the chart
    std::string reason = {};
    Span origin = {};

    bool operator==(const ExclusionRow&) const = default;
};

/// Returns the rows of `file`, or nullopt after at least one error.
std::optional<std::vector<ExclusionRow>> read_exclusions(Id<Source> file, const Sources& sources, const Chart& chart,
                                                         Diagnostics& diagnostics);

}  // namespace grafverif
