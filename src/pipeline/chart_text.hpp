// SPDX-License-Identifier: MIT
// Charts drawn with the comments of their steps and, in Notation::Text, with conditions as their file has them.
#pragma once

#include "draw/chart_text.hpp"
#include "grafverif/grafverif.hpp"

namespace grafverif {

/// Reads the source of the chart again.
ChartText text_of(const Model& model, Id<Chart> chart, const Sources& sources);

Drawing drawing_of(const Model& model, Id<Chart> chart, const DrawOptions& options, const Sources& sources);

}  // namespace grafverif
