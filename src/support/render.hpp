// SPDX-License-Identifier: MIT
// Renders diagnostics as text for a terminal with a given width (see grafverif/support/diagnostic.hpp).
#pragma once

#include <cstddef>
#include <iosfwd>
#include <vector>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Width of source lines in output that is not written to a terminal.
inline constexpr std::size_t usual_columns = 104;
/// Does the same as render_text, with source lines of at most `columns` columns. Text on both sides of the mark is
/// truncated.
void render_text(const std::vector<Diagnostic>& diagnostics, const Sources& sources, Colour colour, std::size_t columns,
                 std::ostream& out);

}  // namespace grafverif
