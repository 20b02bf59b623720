// SPDX-License-Identifier: MIT
// add_incomplete_units: reads the declarations of units in an incomplete text, so that an editor can propose names.
#pragma once

#include "grafverif/support/source.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif::program {

/// Adds to `file` each unit of the text at `whole` that the parser has skipped after a syntax error. An added unit has
/// variables, but no body. Adds a source with the missing end keywords of units to `sources`.
void add_incomplete_units(Span whole, st::File& file, Sources& sources);

}  // namespace grafverif::program
