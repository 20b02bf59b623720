// SPDX-License-Identifier: MIT
// Diagnostics as text for a terminal as wide as it is; see grafverif/support/diagnostic.hpp.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <vector>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// What is not written for a terminal has lines of source as wide as this.
inline constexpr std::size_t usual_columns = 104;
/// As render_text; lines of source take `columns` at most: what does not fit is cut away on either side of what is marked.
void render_text(const std::vector<Diagnostic>& diagnostics, const Sources& sources, Colour colour, std::size_t columns,
                 std::ostream& out);

}  // namespace grafverif
