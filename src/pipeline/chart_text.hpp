// SPDX-License-Identifier: MIT
// Prepares charts for drawing, with the comments of their steps. With Notation::Text, conditions have the same text as
// in the source file.
#pragma once

#include "draw/chart_text.hpp"
#include "grafverif/grafverif.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

/// Returns the texts of the chart's conditions, actions and comments. Parses the source of the chart again.
ChartText text_of(const Model& model, Id<Chart> chart, const Sources& sources);

Drawing drawing_of(const Model& model, Id<Chart> chart, const DrawOptions& options, const Sources& sources);
/// Returns the drawing of a chart without parsing its source again: `file` is the syntax tree of `source`.
Drawing drawing_of(const Model& model, Id<Chart> chart, const DrawOptions& options, const Sources& sources,
                   const tree::File& file, Id<Source> source);

}  // namespace grafverif
