// SPDX-License-Identifier: MIT
// add_incomplete_units: the declarations in the units of an incomplete text, for the names that an editor proposes.
#pragma once

#include "grafverif/support/source.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif::program {

/// Adds to `file` each unit of the text at `whole` that the parser has skipped after a syntax error. Such a unit has
/// variables, but no body. A source with the keywords that end units is added to `sources`.
void add_incomplete_units(Span whole, st::File& file, Sources& sources);

}  // namespace grafverif::program
