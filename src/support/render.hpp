// SPDX-License-Identifier: MIT
// Renders diagnostics as text for a terminal with a given width (see grafverif/support/diagnostic.hpp).
#pragma once

#include <cstddef>
#include <iosfwd>
#include <vector>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// The width of source lines in output that is not written to a terminal.
inline constexpr std::size_t usual_columns = 104;
/// Writes the same text as the public render_text, but with source lines of at most `columns` columns. A longer line is
/// truncated on one or both sides of the marked characters.
void render_text(const std::vector<Diagnostic>& diagnostics, const Sources& sources, Colour colour, std::size_t columns,
                 std::ostream& out);

}  // namespace grafverif
